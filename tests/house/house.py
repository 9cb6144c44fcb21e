"""Runs one house check: over the repository, or with --planted over small trees that break the rule.

A check is a module with RULE (a sentence), check(tree) -> list of violations, CLEAN (path -> text of a tree without
violations) and PLANTED (one changed file each: path, text, and the required content of the violation).
"""

import importlib
import pathlib
import subprocess
import sys
import tempfile


class Tree:
    """The files of the repository: those tracked by git or, without git, all but build output."""

    def __init__(self, root):
        self.root = pathlib.Path(root).resolve()
        self.paths = sorted(self._from_git() or self._from_disk())

    def _from_git(self):
        if not (self.root / ".git").exists():
            return None
        command = ["git", "-C", str(self.root), "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
        try:
            listing = subprocess.run(command, check=True, capture_output=True).stdout.decode()
        except (OSError, subprocess.CalledProcessError):
            return None
        return [path for path in listing.split("\0") if path and (self.root / path).is_file()]

    def _from_disk(self):
        paths = (path.relative_to(self.root) for path in self.root.rglob("*") if path.is_file())
        return [path.as_posix() for path in paths if path.parts[0] not in ("build", ".git")]

    def under(self, folder, *suffixes):
        return [path for path in self.paths if path.startswith(folder) and path.endswith(suffixes or "")]

    def text(self, path):
        """The file's text; empty for a binary file."""
        data = (self.root / path).read_bytes()
        return "" if b"\0" in data else data.decode("utf-8", "replace")

    def lines(self, path):
        return enumerate(self.text(path).splitlines(), 1)


def violations_in(check, files):
    with tempfile.TemporaryDirectory() as folder:
        for path, text in files.items():
            file = pathlib.Path(folder, path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
        return check(Tree(folder))


def run_planted(module):
    problems = [f"the clean tree: {found}" for found in violations_in(module.check, module.CLEAN)]
    for path, text, expected in module.PLANTED:
        found = violations_in(module.check, {**module.CLEAN, path: text})
        if not any(path in violation and expected in violation for violation in found):
            problems.append(f"not seen in {path}: {expected!r}; found instead: {found}")
    return problems


def main():
    name, root, *mode = sys.argv[1:]
    module = importlib.import_module(name)
    problems = run_planted(module) if mode == ["--planted"] else module.check(Tree(root))
    for problem in problems:
        print(problem)
    if problems:
        print(f"{len(problems)} against the rule: {module.RULE}")
        sys.exit(1)


if __name__ == "__main__":
    main()
