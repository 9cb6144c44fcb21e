"""The repository contains no names of package registries and no machine-specific paths."""

import re

RULE = "no package registry's host and no path of one machine in a tracked file"

REGISTRY = re.compile(
    r"\b(?:[\w-]+\.)*(?:debian\.(?:org|net)/debian|(?:deb|security|ftp|snapshot|archive)(?:\.\w+)?\.debian\.(?:org|net)"
    r"|(?:archive|security|ports)\.ubuntu\.com|launchpad\.net|pypi\.org|pythonhosted\.org|npmjs\.(?:org|com)"
    r"|yarnpkg\.com|crates\.io|proxy\.golang\.org|rubygems\.org|docker\.(?:io|com)|ghcr\.io|quay\.io|gcr\.io|pkg\.dev"
    r"|conda\.io|anaconda\.org|conan\.io|nodesource\.com|repo\.maven\.apache\.org)\b"
)
# A machine-specific folder at the start of a path.
MACHINE_PATH = re.compile(r"(?<![\w.$})\]*/~-])/(?:home|root|Users|work|workspace|mnt|media|srv|tmp)/[\w.]")


def check(tree):
    found = []
    for path in tree.paths:
        for number, line in tree.lines(path):
            for kind, pattern in (("registry host", REGISTRY), ("machine path", MACHINE_PATH)):
                match = pattern.search(line)
                if match:
                    found.append(f"{path}:{number}: {kind} {match[0]}")
    return found


CLEAN = {
    "scripts/a.sh": '. /etc/os-release\ncd "$root/work/x"\nls ./tmp/y host/root/z ~/.cache\n',
    "README.md": "see https://www.debian.org and https://doi.org/10.1145/1\n",
}
# Written in pieces: this file is tracked too.
PLANTED = [
    ("scripts/a.sh", "apt http://deb.debian" + ".org/debian\n", "registry host"),
    ("scripts/a.sh", "curl https://files.python" + "hosted.org/x\n", "registry host"),
    ("README.md", "docker pull ghcr" + ".io/x/y\n", "registry host"),
    ("host/a.cpp", 'open("/' + 'home/somebody/x");\n', "machine path"),
    ("CMakeLists.txt", "set(x /" + "work/main)\n", "machine path"),
]
