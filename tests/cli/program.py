"""Shared by the command line tests: running the program, a folder to run it in, and a small scene.

run_class.py sets the tested program and source tree before a test runs.
"""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

USAGE, BAD_INPUT, DEVICE, OUTPUT = 2, 3, 4, 5

# Far longer than any of these runs; a program that hangs fails its test instead of hanging the suite. Sanitizer and
# checked builds need more.
TIMEOUT = 120 * float(os.environ.get("HYALITE_TEST_PATIENCE", "1"))  # [s]

# The smallest scene that lights something. Tests replace one of its parts by their mistake.
SCENE = """hyalite: 1
camera: {position: [0, 0, 4], resolution: [8, 8]}
render: {passes: 1, photons: 100}
materials: {gray: {type: diffuse}}
lights: [{type: point, position: [0, 1, 2]}]
objects: [{shape: {type: sphere, radius: 1}, material: gray}]
"""


class Setup:
    """Paths; filled in by run_class.py."""

    program = None
    source = None
    cache = None


def scene_file(name):
    return str(Setup.source / "scenes" / name)


def default_environment():
    """The caller's environment without hyalite's variables, and with one cache of compiled shaders for all tests."""
    own = {name: value for name, value in os.environ.items() if not name.startswith("HYALITE_")}
    return {**own, "XDG_CACHE_HOME": str(Setup.cache)}


ON_THE_DEVICE = {"render", "parity", "inspect", "bench", "live"}


def command_line(arguments):
    """The program with its arguments; commands that use the device run under the validation layers if requested."""
    command = [str(Setup.program), *map(str, arguments)]
    if "HYALITE_VALIDATION" in os.environ and ON_THE_DEVICE & set(arguments[:1]) and "reference" not in arguments:
        command.append("--validation")
    return command


class CliTest(unittest.TestCase):
    """Runs the program in its own empty folder, `self.folder`."""

    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, content):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def run_program(self, *arguments, environment=None, **options):
        """Runs to the end, whatever the exit code. `environment` is added to the default one."""
        return subprocess.run(
            command_line(list(arguments)),
            cwd=self.folder,
            env={**default_environment(), **(environment or {})},
            stdin=subprocess.DEVNULL,
            **{"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True, "timeout": TIMEOUT, **options},
        )

    def succeed(self, *arguments, **options):
        """Runs; fails the test unless the exit code is 0 and stderr is empty. Returns stdout. That an integrator leaves out
        caustics of a shipped scene is what warnings_test.py checks."""
        result = self.run_program(*arguments, **options)
        errors = "".join(line for line in result.stderr.splitlines(True) if "[unseen-caustic]" not in line)
        self.assertEqual((result.returncode, errors), (0, ""), arguments)
        return result.stdout

    def succeed_json(self, *arguments, **options):
        return json.loads(self.succeed(*arguments, "--json", **options))

    def contents(self):
        """Every file and folder in the test's folder, with its bytes."""
        found = {}
        for path in sorted(self.folder.rglob("*")):
            found[str(path.relative_to(self.folder))] = path.read_bytes() if path.is_file() else None
        return found

    def assert_refused(self, code, words, arguments, **options):
        """The full contract of a failure: its exit code, one line on stderr that contains `words`, and nothing else."""
        before = self.contents()
        result = self.run_program(*arguments, **options)
        said = f"exit code {result.returncode}, stderr: {result.stderr!r}, stdout: {result.stdout!r}"
        self.assertEqual(result.returncode, code, said)
        self.assertTrue(result.stderr.startswith("hyalite: "), said)
        self.assertTrue(result.stderr.endswith("\n") and result.stderr.count("\n") == 1, f"not one line: {said}")
        for word in words:
            self.assertIn(word, result.stderr, said)
        if result.stdout is not None:  # None: the test redirected it
            self.assertEqual(result.stdout, "", said)
        self.assertEqual(self.contents(), before, f"files changed, appeared or went away: {said}")
