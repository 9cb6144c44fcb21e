"""Runs one class of tests: PROGRAM SOURCE CACHE MODULE.CLASS. With --registered MODULE.CLASS... it checks instead that these are all the classes, so that none is forgotten."""

import importlib
import pathlib
import sys
import unittest

from program import CliTest, Setup


def classes_of(module):
    """Classes with tests; the others are base classes."""
    found = vars(importlib.import_module(module)).values()
    candidates = (c for c in found if isinstance(c, type) and issubclass(c, CliTest))
    return {c for c in candidates if unittest.defaultTestLoader.getTestCaseNames(c)}


def check_registered(registered):
    modules = sorted(path.stem for path in pathlib.Path(__file__).parent.glob("*_test.py"))
    present = {f"{module}.{c.__name__}" for module in modules for c in classes_of(module)}
    if set(registered) != present:
        sys.exit(f"in CMakeLists.txt or in the files, but not in both: {sorted(present ^ set(registered))}")


def main():
    if sys.argv[1] == "--registered":
        check_registered(sys.argv[2:])
        return
    program, source, cache, name = sys.argv[1:]
    Setup.program, Setup.source, Setup.cache = (pathlib.Path(path).resolve() for path in (program, source, cache))
    Setup.cache.mkdir(parents=True, exist_ok=True)
    module, test_class = name.split(".")
    suite = unittest.defaultTestLoader.loadTestsFromTestCase(getattr(importlib.import_module(module), test_class))
    result = unittest.TextTestRunner(verbosity=2).run(suite)
    if result.testsRun == 0 or result.skipped or not result.wasSuccessful():
        sys.exit(1)


if __name__ == "__main__":
    main()
