"""The reference and its twins share only layouts, limits and integer functions with the shaders that they check."""

import re

from layers import REFERENCE_MAY_TAKE, includes

RULE = (
    "the reference, with the twins of scenes' own GLSL, reaches, through whatever it includes, no shader but shaders/shared/*.h and nothing of the device's "
    "side; functions there compute with integers alone"
)

DEVICE_SIDE = ("host/gpu/", "host/render/", "host/parity/", "host/cli/")
REAL = re.compile(r"\b(float|double|d?vec[234]|d?mat[234](x[234])?|sqrt|inversesqrt|floor|intBitsToFloat|uintBitsToFloat)\b|\d\.\d")


def reached(tree, path, seen):
    """(file, line, included file) of every include reached from the file."""
    for number, name, target in includes(tree, path):
        yield path, number, name, target
        if target is not None and target not in seen:
            seen.add(target)
            yield from reached(tree, target, seen)


def functions(text):
    """(line, text) of every function shared by both sides."""
    for match in re.finditer(r"^SHARED_FUNCTION\b", text, re.MULTILINE):
        depth, at = 0, text.index("{", match.start())
        for at in range(at, len(text)):
            depth += {"{": 1, "}": -1}.get(text[at], 0)
            if depth == 0:
                break
        code = re.sub(r"//.*", "", text[match.start() : at + 1])
        yield text.count("\n", 0, match.start()) + 1, code


def check(tree):
    tree.path_set = set(tree.paths)
    found = []
    for path in tree.under("host/reference/", ".h", ".cpp") + tree.under("scenes/", ".twin.cpp"):
        for file, number, name, target in reached(tree, path, {path}):
            where = f"{file}:{number}: #include of {name}"
            if target is None:
                continue
            if target.startswith(DEVICE_SIDE):
                found.append(f"{where}: of the device's side, and {path} leads here")
            if target.startswith("shaders/") and not (target.startswith("shaders/shared/") and target.endswith(".h")):
                found.append(f"{where}: a shader's own code, and {path} leads here")
            if file == path and target.startswith("shaders/") and target not in REFERENCE_MAY_TAKE:
                found.append(f"{where}: more than limits and random integers")
    for path in tree.under("shaders/shared/", ".h"):
        for line, code in functions(tree.text(path)):
            real = REAL.search(code)
            if real:
                found.append(f"{path}:{line}: a function that both sides share computes with '{real[0]}'")
    return sorted(set(found))


CLEAN = {
    "host/reference/ppm.cpp": '#include "reference/ppm.h"\n#include "geometry/bvh.h"\n',
    "host/reference/ppm.h": '#include "shaders/shared/random.h"\n#include <vector>\n',
    "host/geometry/bvh.h": '#include "shaders/shared/records.h"\n',
    "host/render/ppm.h": "",
    "scenes/experiments/marble.twin.cpp": '#include "shaders/shared/random.h"\n',
    "shaders/lib/math.glsl": "float square(float x) { return x * x; }\n",
    "shaders/shared/records.h": "struct Ray {\n    vec3 origin;\n    float tMax;\n};\n",
    "shaders/shared/random.h": "// 0.5\nSHARED_FUNCTION uint hash(uint x) {\n    return x * 3u; // vec3\n}\n",
    "shaders/shared/limits.h": "",
}
PLANTED = [
    ("host/reference/ppm.h", '#include "shaders/lib/math.glsl"\n', "a shader's own code"),
    ("host/reference/ppm.h", '#include "shaders/shared/records.h"\n', "more than limits"),
    ("host/geometry/bvh.h", '#include "shaders/lib/math.glsl"\n', "host/reference/ppm.cpp leads here"),
    ("host/geometry/bvh.h", '#include "render/ppm.h"\n', "of the device's side"),
    ("scenes/experiments/marble.twin.cpp", '#include "shaders/lib/math.glsl"\n', "a shader's own code"),
    ("shaders/shared/random.h", "SHARED_FUNCTION float unit(uint x) {\n    return 1;\n}\n", "computes with 'float'"),
    ("shaders/shared/random.h", "SHARED_FUNCTION uint f(uint x) {\n    return uint(x * 0.5);\n}\n", "computes with '0.5'"),
]
