"""Every statistical test case takes its share of the suite's false-alarm rate, and there are enough shares."""

import re

RULE = "no more test cases make a FalseAlarms than kStatisticalTestCases, and each makes it in its own body"

KIT = "tests/support/statistics.h"
SHARES = re.compile(r"kStatisticalTestCases = (\d+);")
MADE = re.compile(r"\bFalseAlarms \w+[({]")


def check(tree):
    shares = SHARES.search(tree.text(KIT))
    if not shares:
        return [f"{KIT}: kStatisticalTestCases is not a plain number"]
    made = [
        f"{path}:{number}: {line.strip()}"
        for path in tree.under("tests/", ".cpp", ".h")
        if not path.startswith("tests/support/statistics")
        for number, line in tree.lines(path)
        if MADE.search(line)
    ]
    found = [f"{place}: make it in a test case" for place in made if place.split(":")[0].endswith(".h")]
    if len(made) > int(shares[1]):
        found.append(f"{KIT}: {shares[1]} shares for {len(made)} test cases: {made[-1]} is one too many")
    return found


CLEAN = {
    KIT: "inline constexpr std::size_t kStatisticalTestCases = 1;\n",
    "tests/image/a_test.cpp": 'TEST_CASE("a mean") {\n    FalseAlarms alarms(3);\n}\n',
}
PLANTED = [
    ("tests/image/b_test.cpp", "    FalseAlarms alarms(3);\n", "FalseAlarms"),
    ("tests/image/b.h", "    FalseAlarms alarms(3);\n", "make it in a test case"),
    (KIT, "constexpr auto kStatisticalTestCases = many();\n", "not a plain number"),
]
