"""Warnings about scenes and pictures: their lines, their places, and --strict."""

import json
import os

from exr import Picture
from program import BAD_INPUT, SCENE, CliTest, scene_file

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
        self.write("dark.yaml", DARK + "accept: [unseen-light]\n")
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


class Faces(WarningTest):
    """Meshes that a file lists wrongly: their warnings, and the pictures of what is meant."""

    def check(self, name, integrator, backend, mean, tolerance, *options):
        self.succeed("render", scene_file(f"tests/{name}.yaml"), "--integrator", integrator, "--backend", backend, *options,
                     "--quiet", "-o", "a.exr")
        values = list(Picture(self.folder / "a.exr").values())
        self.assertAlmostEqual(sum(values) / len(values) / mean, 1, delta=tolerance, msg=f"{integrator}, {backend}")

    def test_a_lamp_whose_faces_are_listed_twice_gives_its_light_once(self):
        # One sample of the lamp's quarter of the hemisphere varies by a few per cent of its mean: in 64 pixels and 64
        # passes the mean varies by less than 0.2 %; that of photons in a radius of 0.1 m by 1 %.
        for backend in BACKENDS:
            for integrator in ("whitted", "path"):
                self.check("lamp-faces-twice", integrator, backend, 0.36739, 0.01)
            for integrator in ("ppm", "photonmap"):
                self.check("lamp-faces-twice", integrator, backend, 0.36739, 0.02, "--passes", "16", "--photons", "2000")

    def test_an_inside_out_pane_absorbs_like_the_same_pane_wound_outward(self):
        # Up to 0.25 degrees off the axis the path through the glass is longer by 4e-6 and the Fresnel terms are equal.
        for backend in BACKENDS:
            self.check("inside-out-pane", "whitted", backend, 0.33911, 0.0005)
            # Reflects or refracts at random; ppm and photonmap warn that there is nothing diffuse
            self.check("inside-out-pane", "path", backend, 0.33911, 0.02, "--passes", "256", "--set", "render.max_depth=12")

    def warning_lines(self, scene, mesh):
        self.write("scene.yaml", scene)
        self.write("mesh.obj", mesh)
        return self.warnings_of("scene.yaml")

    def test_each_fault_of_a_mesh_is_reported_at_its_line(self):
        card = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
        inward = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n"
        shape = "{type: mesh, file: mesh.obj}"
        glass = SCENE.replace("{type: sphere, radius: 1}", shape).replace("type: diffuse", "type: dielectric")
        gray = SCENE.replace("{type: sphere, radius: 1}", shape)
        cases = [
            (gray, card + "f 2 3 1\n", "mesh.obj:5:1: this face lists a triangle of line 4 again", "repeated-faces"),
            (glass, card, "mesh.obj:4:1: this mesh of glass (material 'gray') is open beside this face", "open-glass"),
            (glass, inward, "mesh.obj:5:1: this closed mesh is glass (material 'gray') but wound inward", "turned-faces"),
        ]
        for scene, mesh, words, kind in cases:
            with self.subTest(kind):
                found = [line for line in self.warning_lines(scene, mesh) if f"[{kind}]" in line]
                self.assertEqual(len(found), 1, found)
                self.assertTrue(found[0].startswith(words), found[0])

    def test_strict_ends_before_the_render_and_leaves_no_file(self):
        self.write("twice.yaml", SCENE.replace("objects: [", "objects: [{shape: {type: sphere, radius: 1}, material: gray}, "))
        column = SCENE.splitlines()[5].index("{shape") + len("{shape: {type: sphere, radius: 1}, material: gray}, ") + 1
        words = [f"twice.yaml:6:{column}: this object has the shape and the place of the object at line 6 column 11",
                 "[repeated-object] (remove one of them)"]
        for command in ("render", "parity"):
            self.assert_refused(BAD_INPUT, words, [command, "twice.yaml", "--strict"])


class Lights(WarningTest):
    """Lights that reach nothing, and caustics that an integrator leaves out."""

    def of_kind(self, kind, scene, *options):
        self.write("scene.yaml", scene)
        return [line for line in self.warnings_of("scene.yaml", *options) if f"[{kind}]" in line]

    def test_a_light_in_a_closed_solid_is_named(self):
        column = SCENE.splitlines()[4].index("{type") + 1
        words = f"scene.yaml:5:{column}: none of 1024 paths from this point light reaches what the camera sees"
        found = self.of_kind("unseen-light", DARK)
        self.assertEqual([line[: len(words)] for line in found], [words])
        self.assertEqual(self.of_kind("unseen-light", SCENE), [])

    def test_path_and_whitted_say_which_caustic_they_leave_out(self):
        floor = "{shape: {type: plane, point: [0, -2, 0], normal: [0, 1, 0]}, material: gray}"
        scene = SCENE.replace("gray: {type: diffuse}", "gray: {type: diffuse}, ball: {type: dielectric}").replace(
            "material: gray}]", f"material: ball}}, {floor}]").replace("position: [0, 1, 2]", "position: [0, 3, 0]")
        column = scene.splitlines()[4].index("{type") + 1
        for integrator in ("path", "whitted"):
            found = self.of_kind("unseen-caustic", scene, "--integrator", integrator, "--set", "render.max_depth=8")
            self.assertEqual(len(found), 1, found)
            for words in (f"scene.yaml:5:{column}: integrator {integrator} does not show", "this point light",
                          "over the glass 'ball' (the object at line 6 column 11)", "(ppm shows caustics)"):
                self.assertIn(words, found[0])
        for integrator in ("ppm", "photonmap"):
            self.assertEqual(self.of_kind("unseen-caustic", scene, "--integrator", integrator), [])
        clear = scene.replace("type: dielectric", "type: dielectric, ior: 1")
        self.assertEqual(self.of_kind("unseen-caustic", clear, "--integrator", "path"), [])
