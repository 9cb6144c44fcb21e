"""Every file under shaders/ is reached from a kernel, every kernel is run by the host and stands in the kernels' README.

None asks for gl_SubgroupSize, which lavapipe sometimes compiles in wrong (shaders/lib/thread.glsl).
"""

import posixpath
import re

RULE = "every shader file is included, every kernel is run by name and listed in shaders/kernels/README.md; none asks for gl_SubgroupSize"

INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"')
README = "shaders/kernels/README.md"


def includes(tree, path):
    """(line, name, file or None): resolved beside the including file, then in shaders/, as the compiler does."""
    for number, line in tree.lines(path):
        match = INCLUDE.match(line)
        if match:
            places = [posixpath.dirname(path), "shaders"]
            candidates = [posixpath.normpath(posixpath.join(place, match[1])) for place in places]
            yield number, match[1], next((c for c in candidates if c in tree.path_set), None)


def reached_from(tree, starts):
    reached, waiting = set(), list(starts)
    while waiting:
        path = waiting.pop()
        if path not in reached:
            reached.add(path)
            waiting += [target for _, _, target in includes(tree, path) if target]
    return reached


def check(tree):
    tree.path_set = set(tree.paths)
    sources = tree.under("shaders/", ".comp", ".glsl", ".h")
    kernels = [path for path in sources if path.endswith(".comp")]
    found = [
        f"{path}:{number}: #include of {name}: there is no such file"
        for path in sources
        for number, name, target in includes(tree, path)
        if target is None
    ]
    reached = reached_from(tree, kernels)
    found += [f"{path}: no kernel includes it" for path in sources if path not in reached]
    found += [
        f"{path}:{number}: lavapipe sometimes compiles gl_SubgroupSize in wrong: divide by gl_NumSubgroups"
        for path in sources
        for number, line in tree.lines(path)
        if "gl_SubgroupSize" in line.split("//")[0]
    ]
    host = "".join(tree.text(path) for path in tree.under("host/", ".cpp", ".h"))
    names = {posixpath.basename(path)[: -len(".comp")]: path for path in kernels}
    found += [f"{path}: no host source names it" for name, path in names.items() if f'"{name}"' not in host]
    if kernels and README not in tree.path_set:
        return found + [f"{README}: missing"]
    # A row of the table: | `kernel` | reads | ...
    listed = set(re.findall(r"^\|\s*\[?`?([a-z0-9_]+)(?:\.comp)?`?", tree.text(README), re.M)) if kernels else set()
    found += [f"{path}: not in {README}" for name, path in names.items() if name not in listed]
    found += [f"{README}: lists {name}, which is no kernel" for name in sorted(listed - set(names) - {"kernel"})]
    return found


CLEAN = {
    "shaders/kernels/trace_closest.comp": '#include "lib/ray.glsl"\n',
    "shaders/kernels/README.md": "| kernel | reads |\n|---|---|\n| `trace_closest` | rays |\n",
    "shaders/lib/ray.glsl": '#include "../shared/records.h"\n',
    "shaders/shared/records.h": '#include "limits.h"\n',
    "shaders/shared/limits.h": "",
    "host/render/ppm.cpp": 'kernel("trace_closest");\n',
}
PLANTED = [
    ("shaders/lib/unused.glsl", "\n", "no kernel includes it"),
    ("shaders/shared/unused.h", "\n", "no kernel includes it"),
    ("shaders/lib/ray.glsl", '#include "shared/records.h"\n#include "lib/gone.glsl"\n', "no such file"),
    ("shaders/kernels/new_kernel.comp", "\n", "no host source names it"),
    ("shaders/kernels/new_kernel.comp", "\n", "not in shaders/kernels/README.md"),
    ("shaders/shared/limits.h", "// of\nuint lanes() { return gl_SubgroupSize; }\n", "limits.h:2: lavapipe sometimes"),
    ("shaders/kernels/README.md", "| `trace_closest` | rays |\n| `old_kernel` | - |\n", "which is no kernel"),
]
