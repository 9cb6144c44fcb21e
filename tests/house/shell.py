"""The shell scripts pass shellcheck and start with the same lines."""

import os
import subprocess

RULE = "every shell script passes shellcheck, stops at the first error and may be executed"


def is_script(tree, path):
    return path.endswith(".sh") or tree.text(path).startswith(("#!/usr/bin/env bash", "#!/bin/bash", "#!/bin/sh"))


def check(tree):
    scripts = [path for path in tree.paths if is_script(tree, path)]
    found = [f"{path}: no 'set -euo pipefail'" for path in scripts if "\nset -euo pipefail\n" not in tree.text(path)]
    found += [f"{path}: not executable" for path in scripts if not os.access(tree.root / path, os.X_OK)]
    if not scripts:
        return found
    try:
        result = subprocess.run(
            ["shellcheck", "--format=gcc", *scripts], cwd=tree.root, capture_output=True, text=True
        )
    except FileNotFoundError:
        return found + ["shellcheck is not installed: run scripts/install-deps.sh test"]
    return found + result.stdout.splitlines() + result.stderr.splitlines()


CLEAN = {"README.md": "see scripts/\n"}
PLANTED = [
    ("scripts/a.sh", '#!/usr/bin/env bash\nset -euo pipefail\necho $1\n', "SC2086"),
    ("scripts/a.sh", '#!/usr/bin/env bash\necho "$1"\n', "set -euo pipefail"),
    (".ci/run", "#!/usr/bin/env bash\nset -euo pipefail\nls\n", "not executable"),
]
