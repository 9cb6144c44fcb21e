"""scripts/backports_entry.awk: its output for apt sources of each kind."""

import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "backports_entry.awk"
URI = "http://mirror.example/debian/"


def entry(kind, text):
    with tempfile.NamedTemporaryFile("w", suffix=".txt") as file:
        file.write(text)
        file.flush()
        command = ["awk", "-v", f"uri={URI}", "-v", "codename=bookworm", "-v", f"format={kind}", "-f", PROGRAM, file.name]
        return subprocess.run(command, check=True, capture_output=True, text=True).stdout


class OneLine(unittest.TestCase):
    def test_a_plain_entry_keeps_its_uri(self):
        self.assertEqual(
            entry("one-line", "deb http://mirror.example/debian bookworm main contrib\n"),
            "deb http://mirror.example/debian bookworm-backports main\n",
        )

    def test_options_are_kept(self):
        self.assertEqual(
            entry("one-line", "deb [ arch=amd64 signed-by=/usr/share/k.gpg ] http://mirror.example/debian/ bookworm main # x\n"),
            "deb [ arch=amd64 signed-by=/usr/share/k.gpg ] http://mirror.example/debian/ bookworm-backports main\n",
        )

    def test_other_entries_are_passed_over(self):
        text = (
            "# deb http://mirror.example/debian bookworm main\n"
            "deb-src http://mirror.example/debian bookworm main\n"
            "deb http://mirror.example/debian bookworm-updates main\n"
            "deb http://mirror.example/debian-security bookworm main\n"
            "deb [trusted=yes] http://third.example/debian bookworm main\n"
            "deb http://mirror.example/debian trixie main\n"
        )
        self.assertEqual(entry("one-line", text), "")
        self.assertEqual(
            entry("one-line", text + "\tdeb http://mirror.example/debian bookworm main\n"),
            "deb http://mirror.example/debian bookworm-backports main\n",
        )


class Deb822(unittest.TestCase):
    def test_key_and_options_are_kept_and_sources_are_not(self):
        text = (
            "Types: deb deb-src\n"
            "# a comment\n"
            "URIs: http://mirror.example/debian\n"
            "Suites: bookworm bookworm-updates\n"
            "Components: main contrib\n"
            "Signed-By:\n"
            " -----BEGIN PGP PUBLIC KEY BLOCK-----\n"
            " .\n"
            " abc\n"
            "Check-Valid-Until: no\n"
        )
        self.assertEqual(
            entry("deb822", text),
            "Types: deb\nSuites: bookworm-backports\nComponents: main\n"
            "URIs: http://mirror.example/debian\n"
            "Signed-By:\n -----BEGIN PGP PUBLIC KEY BLOCK-----\n .\n abc\nCheck-Valid-Until: no\n",
        )

    def test_the_right_one_of_several_stanzas_is_taken(self):
        security = "Types: deb\nURIs: http://mirror.example/debian-security\nSuites: bookworm-security\nComponents: main\n"
        third = "Types: deb\nURIs: http://third.example/debian\nSuites: bookworm\nComponents: main\n"
        source = "Types: deb-src\nURIs: http://mirror.example/debian\nSuites: bookworm\nComponents: main\n"
        off = "Enabled: no\nTypes: deb\nURIs: http://mirror.example/debian\nSuites: bookworm\nComponents: main\n"
        own = "types: deb\nuris: http://mirror.example/debian/\nsuites:\n trixie\n bookworm\ncomponents: main\nsigned-by: /k.gpg\n"
        others = "\n".join([security, third, source, off])
        self.assertEqual(entry("deb822", others), "")
        self.assertEqual(
            entry("deb822", others + "\n" + own),
            "Types: deb\nSuites: bookworm-backports\nComponents: main\n"
            "uris: http://mirror.example/debian/\nsigned-by: /k.gpg\n",
        )


if __name__ == "__main__":
    unittest.main()
