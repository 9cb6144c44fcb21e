"""Warnings about scenes and pictures: their lines, their places, and --strict."""

import json
import os

from exr import Picture
from program import BAD_INPUT, SCENE, CliTest

BACKENDS = ("vulkan", "reference")
BLACK = "no light reached any pixel: the picture is black [black-picture] ("

# The light is in a closed ball, and the camera outside.
DARK = SCENE.replace("position: [0, 1, 2]", "position: [0, 0, 0]")


class WarningTest(CliTest):
    def warnings_of(self, *arguments):
        """Renders; the warnings on stderr, which are those of the JSON report."""
        result = self.run_program("render", *arguments, "--json", "-o", "a.exr")
        self.assertEqual(result.returncode, 0, result.stderr)
        lines = result.stderr.splitlines()
        for line in lines:
            self.assertTrue(line.startswith("hyalite: warning: "), line)
        warnings = [line.removeprefix("hyalite: warning: ") for line in lines]
        self.assertEqual(json.loads(result.stdout)["warnings"], warnings)
        return warnings


class Channel(WarningTest):
    def test_a_black_picture_is_reported_after_it_is_written(self):
        self.write("dark.yaml", DARK)
        for backend in BACKENDS:
            with self.subTest(backend):
                black = [line for line in self.warnings_of("dark.yaml", "--backend", backend) if "[black-picture]" in line]
                self.assertEqual(len(black), 1)
                self.assertTrue(black[0].startswith("dark.yaml: " + BLACK), black)
                self.assertEqual(max(Picture(self.folder / "a.exr").values()), 0)
                os.remove(self.folder / "a.exr")

    def test_a_picture_with_one_lit_pixel_is_not_black(self):
        self.write("scene.yaml", SCENE)
        for backend in BACKENDS:
            with self.subTest(backend):
                self.assertEqual(self.warnings_of("scene.yaml", "--backend", backend), [])

    def test_strict_makes_a_warning_of_the_picture_an_error_and_keeps_the_picture(self):
        self.write("dark.yaml", DARK + "accept: []\n")
        for backend in BACKENDS:
            with self.subTest(backend):
                strict = ["--strict", "--backend", backend, "--set", "render.integrator=whitted"]
                result = self.run_program("render", "dark.yaml", *strict, "-o", "a.exr")
                self.assertEqual(result.returncode, BAD_INPUT, result.stderr)
                self.assertIn("hyalite: dark.yaml: " + BLACK, result.stderr)
                self.assertNotIn("warning:", result.stderr)
                self.assertTrue((self.folder / "a.exr").exists())
                os.remove(self.folder / "a.exr")

    def test_strict_passes_a_scene_without_warnings(self):
        self.write("scene.yaml", SCENE)
        for command in (["render", "--quiet"], ["parity"], ["bench", "--stage", "camera", "--runs", "1"]):
            with self.subTest(command[0]):
                result = self.run_program(command[0], "scene.yaml", *command[1:], "--strict")
                self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_merged_passes_that_are_black_are_reported(self):
        self.write("dark.yaml", DARK)
        self.run_program("render", "dark.yaml", "--quiet", "--checkpoint", "part")
        merged = self.run_program("merge", "part", "--quiet", "-o", "a.exr")
        self.assertEqual(merged.returncode, 0, merged.stderr)
        self.assertIn("hyalite: warning: dark.yaml: " + BLACK, merged.stderr)
        self.assertEqual(self.run_program("merge", "part", "--strict", "-o", "b.exr").returncode, BAD_INPUT)

    def test_a_scene_accepts_warnings_by_name(self):
        self.write("dark.yaml", DARK + "accept: [black-picture]\n")
        self.assertFalse([line for line in self.warnings_of("dark.yaml") if "[black-picture]" in line])
        wrong = DARK + "accept: [black-pictures]\n"
        self.write("wrong.yaml", wrong)
        words = [f"wrong.yaml:{wrong.count(chr(10))}:10: unknown warning 'black-pictures' (did you mean 'black-picture'?)"]
        self.assert_refused(BAD_INPUT, words, ["render", "wrong.yaml"])
