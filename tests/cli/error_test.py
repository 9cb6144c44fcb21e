"""The estimated error of a picture: it is accurate, it ends a render, and it is reported."""

import json
import math

from exr import Picture
from program import USAGE, SCENE, CliTest, scene_file

# Edges, mirrors and glass; soft shadows; caustics and photon noise. Small, so that each takes a few seconds.
SCENES = {
    "reflections": ["--integrator", "whitted", "--resolution", "48x48"],
    "cornell-box": ["--integrator", "whitted", "--max-depth", "5", "--resolution", "48x48"],
    "cornell-caustics": ["--photons", "10000", "--resolution", "24x24", "--set", "render.radius=0.06"],
}


class TargetError(CliTest):
    def render(self, scene, *options):
        """The report; stderr may have a warning."""
        result = self.run_program("render", scene, *options, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout), result.stderr

    def stopped_and_true(self, scene, options, seed):
        """The report of a render that stops at 0.05, and the relMSE of its picture."""
        stopped = ["--passes", "1000", "--target-error", "0.05", "--seed", str(seed), "-o", "a.exr"]
        report, said = self.render(scene, *options, *stopped)
        self.assertEqual(said, "")
        self.assertIs(report["target_error_met"], True)
        self.assertLessEqual(report["error_estimate"], 0.05)
        self.assertGreaterEqual(report["passes"], 16)
        self.assertLess(report["passes"], 1000)
        more = ["--passes", str(8 * report["passes"]), "--seed", str(100 - seed), "--quiet", "-o", "true.exr"]
        self.succeed("render", scene, *options, *more)
        return report, self.succeed_json("compare", "a.exr", "true.exr")["relmse"]

    def test_a_render_stops_at_the_error_asked_for_and_the_true_error_is_what_it_says(self):
        # The expectation of relMSE is the square of the estimate. In a single picture, half of it can come from pixels
        # whose variance depends on few paths, so sums over several seeds are compared. The reference picture has
        # another seed and eight times the passes: its own error adds at most 6 %. The estimate has one degree of
        # freedom per pixel and channel, 2 % or 4 % over a picture; the rest of the factor covers those pixels and ppm's
        # bias.
        for name, options in SCENES.items():
            with self.subTest(name):
                ends = [self.stopped_and_true(scene_file(f"{name}.yaml"), options, seed) for seed in (1, 2, 3)]
                true = math.sqrt(sum(relmse for _, relmse in ends))
                estimate = math.sqrt(sum(report["error_estimate"] ** 2 for report, _ in ends))
                self.assertLess(true, 1.5 * estimate)
                self.assertGreater(true, estimate / 1.5)

    def test_stopping_changes_nothing_but_the_number_of_passes(self):
        scene, options = scene_file("reflections.yaml"), SCENES["reflections"]
        report, _ = self.render(scene, *options, "--passes", "1000", "--target-error", "0.05", "-o", "a.exr")
        self.succeed("render", scene, *options, "--passes", str(report["passes"]), "--quiet", "-o", "b.exr")
        files = self.contents()
        self.assertEqual(files["a.exr"], files["b.exr"])

    def test_both_backends_estimate_the_same_error_and_stop_at_the_same_pass(self):
        scene, options = scene_file("reflections.yaml"), SCENES["reflections"]
        stop = ["--passes", "1000", "--target-error", "0.05", "-o", "a.exr"]
        device, _ = self.render(scene, *options, *stop)
        reference, _ = self.render(scene, *options, *stop, "--backend", "reference")
        # In single precision at most one path in a hundred diverges (see render_test.Backends).
        self.assertAlmostEqual(device["error_estimate"], reference["error_estimate"], delta=0.01 * 0.05)
        self.assertEqual(device["passes"], reference["passes"])

    def test_an_error_that_is_not_reached_is_warned_of(self):
        self.write("scene.yaml", SCENE)
        for backend in ("vulkan", "reference"):
            report, said = self.render("scene.yaml", "--passes", "3", "--target-error", "1e-9", "--backend", backend)
            self.assertIs(report["target_error_met"], False)
            self.assertEqual(report["passes"], 3)
            self.assertIn("hyalite: warning: the target error of 1e-09 was not reached", said)
            self.assertIn("after 3 passes", said)
            self.assertEqual(len(report["warnings"]), 1)
        result = self.run_program("render", "scene.yaml", "--passes", "3", "--target-error", "1e-9")
        self.assertRegex(result.stdout, r"estimated error [\d.e-]+ \(target 1e-09 not met\)(, \d+ pixels?: no light found yet)?\n$")
        said = self.succeed("render", "scene.yaml", "--passes", "3", "--target-error", "10")
        self.assertRegex(said, r"estimated error [\d.e-]+ \(target 10 met\)(, \d+ pixels?: no light found yet)?\n$")

    def test_one_pass_has_no_estimate_and_reaches_no_target(self):
        self.write("scene.yaml", SCENE)
        report, said = self.render("scene.yaml", "--passes", "1", "--target-error", "10")
        self.assertIsNone(report["error_estimate"])
        self.assertIs(report["target_error_met"], False)
        self.assertIn("there is no estimate after 1 pass", said)

    def test_what_was_not_found_is_unknown_on_both_backends(self):
        # A sun that a roof keeps out, and a floor in its shadow: nothing is found, and no target is met
        scene = """
hyalite: 1
camera: {position: [0, 0.5, 0], look_at: [0, 0, 0], up: [0, 0, 1], resolution: [8, 8]}
render: {integrator: INTEGRATOR, passes: 20, photons: 100, max_depth: 3, target_error: 10}
materials: {white: {type: diffuse}, black: {type: diffuse, albedo: 0}}
lights: [{type: directional, direction: [0, -1, 0], irradiance: 100}]
objects:
  - {shape: {type: quad, corner: [-1, 0, 1], edges: [[2, 0, 0], [0, 0, -2]]}, material: white}
  - {shape: {type: sphere, center: [0, 0, 0], radius: 3}, material: black}
"""
        for integrator in ("path", "ppm"):
            self.write("scene.yaml", scene.replace("INTEGRATOR", integrator))
            for backend in ("vulkan", "reference"):
                report, said = self.render("scene.yaml", "--backend", backend)
                self.assertIsNone(report["error_estimate"])
                self.assertEqual((report["passes"], report["pixels_without_light"]), (20, 64))
                self.assertIs(report["target_error_met"], False)
                self.assertIn("there is no estimate after 20 passes, 64 pixels: no light found yet", said)

    def test_a_time_limit_still_ends_a_render_that_has_a_target(self):
        self.write("scene.yaml", SCENE)
        report, said = self.render("scene.yaml", "--passes", "10000000", "--target-error", "1e-9", "--time", "0.5")
        self.assertLess(report["passes"], 10000000)
        self.assertIn("was not reached", said)

    def test_values_that_are_no_errors_are_refused(self):
        self.write("scene.yaml", SCENE)
        for value in ("-0.1", "nan", "small", "1e300"):
            self.assert_refused(USAGE, ["--target-error", "target_error"],
                                ["render", "scene.yaml", f"--target-error={value}"])

    def test_the_layer_error_is_what_the_estimate_is_made_of(self):
        for name, options in SCENES.items():
            report, _ = self.render(scene_file(f"{name}.yaml"), *options, "--passes", "5", "--layers", "-o", "a.exr")
            mean = Picture(self.folder / "a.exr").values()
            error = Picture(self.folder / "a.exr", layer="error").values()
            squares = [e * e / (m * m + 0.01) for e, m in zip(error, mean)]
            # Single-precision sums of 64 pixels at a time: a few roundings of 6e-8
            self.assertAlmostEqual(math.sqrt(sum(squares) / len(squares)) / report["error_estimate"], 1, delta=1e-5)
