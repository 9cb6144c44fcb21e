"""clang-format has nothing to change; version 19, which both Debian 12 and 13 provide."""

import subprocess

RULE = "C++ sources and the headers they share with the shaders are as clang-format leaves them (scripts/format.sh)"

FORMATTER = "clang-format-19"


def check(tree):
    files = [
        path
        for folder in ("host/", "tests/", "shaders/shared/", "scenes/experiments/")
        for path in tree.under(folder, ".h", ".cpp")
    ]
    command = [FORMATTER, "--dry-run", "--Werror", *files]
    try:
        result = subprocess.run(command, cwd=tree.root, capture_output=True, text=True)
    except FileNotFoundError:
        return [f"{FORMATTER} is not installed: run scripts/install-deps.sh test"]
    found = [line for line in result.stderr.splitlines() if "error:" in line]
    return found or ([result.stderr] if result.returncode else [])


STYLE = "BasedOnStyle: LLVM\nIndentWidth: 4\n"
CLEAN = {".clang-format": STYLE, "host/a.cpp": "int f() { return 1; }\n", "shaders/shared/a.h": "int f();\n"}
PLANTED = [
    ("host/a.cpp", "int  f() { return 1; }\n", "clang-format"),
    ("tests/b.cpp", "int f( ) { return 1; }\n", "clang-format"),
    ("shaders/shared/a.h", "int f() ;\n", "clang-format"),
]
