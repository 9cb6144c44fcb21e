"""Catch2's features for skipping a test, or letting it fail, are not used."""

import re

RULE = "no SKIP, and no test hidden or allowed to fail by a tag"

WAYS_OUT = re.compile(r"^\s*SKIP\s*\(|\[\.[\w ]*\]|\[!(?:mayfail|shouldfail|throws)\]|DISABLED\s+(?:TRUE|ON|1)|WILL_FAIL")


def check(tree):
    found = []
    for path in tree.under("tests/", ".cpp", ".h", "CMakeLists.txt"):
        for number, line in tree.lines(path):
            match = WAYS_OUT.search(line)
            if match:
                found.append(f"{path}:{number}: {match[0].strip()}")
    return found


CLEAN = {
    "tests/unit/a.cpp": 'TEST_CASE("a ray hits", "[ray]") { CHECK(skip(1) == 1); }\n',
    "tests/CMakeLists.txt": "set_tests_properties(x PROPERTIES LABELS unit)\n",
}
PLANTED = [
    ("tests/unit/a.cpp", '    SKIP("no device");\n', "SKIP("),
    ("tests/unit/a.cpp", 'TEST_CASE("a ray hits", "[.][ray]") {}\n', "[.]"),
    ("tests/unit/a.cpp", 'TEST_CASE("a ray hits", "[ray][!mayfail]") {}\n', "[!mayfail]"),
    ("tests/CMakeLists.txt", "set_tests_properties(x PROPERTIES DISABLED TRUE)\n", "DISABLED"),
]
