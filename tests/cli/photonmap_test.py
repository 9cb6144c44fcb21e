"""Two-pass photon mapping as users see it: flux account, saved maps, warnings, layers, views."""

import json
import shutil
import struct

from exr import Picture
from program import BAD_INPUT, USAGE, CliTest, Setup

FEW = ["--resolution", "24x24", "--passes", "1", "--max-depth", "8", "--photons", "3000",
       "--set", "render.caustic_photons=3000"]
PHOTON_MAP = ["--integrator", "photonmap", *FEW]

# A glass ball above a floor, under a point light.
BALL = """hyalite: 1
camera: {position: [0, 1, 4], resolution: [16, 16]}
render: {integrator: photonmap, passes: 1, photons: 2000, caustic_photons: 2000}
materials: {floor: {type: diffuse}, glass: {type: dielectric}}
lights: [{type: point, position: [0, 3, 0], intensity: 5}]
objects:
  - {shape: {type: quad, corner: [-3, -1, -3], edges: [[0, 0, 6], [6, 0, 0]]}, material: floor}
  - {shape: {type: sphere, radius: 0.5}, material: glass}
"""


class Flux(CliTest):
    def test_what_every_light_emits_is_stored_absorbed_escapes_or_is_cut_off_in_every_scene(self):
        scenes = sorted((Setup.source / "scenes").rglob("*.yaml"))
        self.assertGreaterEqual(len(scenes), 15, scenes)
        for scene in scenes:
            with self.subTest(scene.name):
                arguments = ["render", str(scene), *PHOTON_MAP, "--json", "-o", "a.png"]
                result = self.run_program(*arguments)  # a warning is allowed: some scenes have no caustics
                self.assertEqual(result.returncode, 0, result.stderr)
                report = json.loads(result.stdout)
                self.assertGreater(len(report["lights"]), 0)
                emitted = [0.0, 0.0, 0.0]
                for light in report["lights"]:
                    for channel in range(3):
                        parts = [light[fate][channel] for fate in ("stored", "absorbed", "escaped", "cut_off")]
                        emitted[channel] += light["emitted"][channel]
                        # The device sums in floats: a few roundings of 6e-8 each along a path
                        self.assertAlmostEqual(sum(parts), light["emitted"][channel],
                                               delta=1e-5 * light["emitted"][channel])
                self.assertGreater(sum(emitted), 0)

    def test_aimed_caustic_photons_are_stored_far_more_often_than_others(self):
        # The ball covers (0.5 / 3)^2 / 4 = 0.7 % of the light's directions
        self.write("ball.yaml", BALL)
        share = {}
        for aimed in ("true", "false"):
            counts = self.succeed_json("render", "ball.yaml", "--set", f"render.projection_map={aimed}",
                                       "--set", "render.caustic_photons=20000", "-o", "a.png")["counts"]
            self.assertEqual(counts["caustic_photons_emitted"], 20000)
            share[aimed] = counts["caustic_photons_stored"] / 20000
        self.assertGreater(share["true"], 0.8)
        self.assertLess(share["false"], 0.011)


class FinalGathering(CliTest):
    # Inside a diffuse sphere every ray ends at its first hit: one camera ray per pixel and pass, and three gather rays
    # from there.
    SPHERE = """hyalite: 1
camera: {position: [0, 0, 0.5], resolution: [9, 7]}
render: {integrator: photonmap, passes: 2, photons: 500, gather_rays: 3}
materials: {wall: {type: diffuse}}
lights: [{type: point, position: [0, 0, 0], intensity: 5}]
objects: [{shape: {type: sphere, radius: 2}, material: wall}]
"""

    def test_its_rays_are_counted_among_those_of_the_camera(self):
        self.write("sphere.yaml", self.SPHERE)
        counts = self.succeed_json("render", "sphere.yaml", "-o", "a.png")["counts"]
        self.assertEqual(counts["gathering_rays"], 9 * 7 * 2 * 3)
        self.assertEqual(counts["camera_rays"], 9 * 7 * 2 * (1 + 3))
        profile = self.succeed("render", "sphere.yaml", "--profile", "-o", "a.png")
        self.assertIn("gathering rays: 378 of 504, 75.0 %", profile)
        none = self.succeed_json("render", "sphere.yaml", "--set", "render.gather_rays=0", "-o", "a.png")["counts"]
        self.assertEqual(none["gathering_rays"], 0)

    def test_its_count_comes_through_checkpoints_and_merge(self):
        self.write("sphere.yaml", self.SPHERE)
        for first in (0, 1):
            self.succeed("render", "sphere.yaml", "--passes", f"{first}:{first + 1}", "--checkpoint", f"{first}", "-o", "a.png")
        counts = self.succeed_json("merge", "0", "1", "-o", "a.png")["counts"]
        self.assertEqual(counts["gathering_rays"], 9 * 7 * 2 * 3)


class SavedMaps(CliTest):
    def setUp(self):
        super().setUp()
        self.write("ball.yaml", BALL)

    def test_loaded_maps_give_the_same_bytes_as_traced_ones_from_any_camera(self):
        self.succeed("render", "ball.yaml", "--save-photons", "maps", "-o", "a.exr")
        self.succeed("render", "ball.yaml", "--load-photons", "maps", "-o", "b.exr")
        self.assertEqual((self.folder / "a.exr").read_bytes(), (self.folder / "b.exr").read_bytes())
        self.succeed("render", "ball.yaml", "--load-photons", "maps", "--set", "camera.position=[2, 2, 2]", "-o", "c.exr")

    def save(self, scene="ball.yaml", *options):
        self.succeed("render", scene, "--save-photons", "maps", "-o", "a.exr", *options)

    def assert_not_loaded(self, what, scene="ball.yaml", *options):
        self.assert_refused(BAD_INPUT, ["maps: the photon maps are from a different render: " + what],
                            ["render", scene, "--load-photons", "maps", "-o", "b.exr", *options])

    def test_maps_of_another_scene_or_other_settings_are_refused_by_the_name_of_what_differs(self):
        self.save()
        self.write("other.yaml", BALL.replace("radius: 0.5", "radius: 0.51"))
        self.assert_not_loaded("the scene's hash is ", "other.yaml")
        for setting, there in {"photons=2001": "2000", "caustic_photons=1": "2000", "seed=2": "1", "max_depth=5": "12",
                               "sampler=independent": "sobol", "projection_map=false": "true"}.items():
            with self.subTest(setting):
                name, here = setting.split("=")
                self.assert_not_loaded(f"render.{name} is {there} there and {here} here", "ball.yaml",
                                       "--set", f"render.{setting}")
        self.assert_not_loaded("render.shadow_photons is 0 there and not 0 here", "ball.yaml",
                               "--set", "render.shadow_photons=2")

    def test_settings_of_the_second_pass_may_change(self):
        self.save("ball.yaml", "--set", "render.shadow_photons=2")
        for setting in ("shadow_photons=3", "nearest=20", "gather_rays=0", "caustic_filter=none", "passes=2"):
            with self.subTest(setting):
                self.succeed("render", "ball.yaml", "--load-photons", "maps", "-o", "b.exr",
                             "--set", "render.shadow_photons=2", "--set", f"render.{setting}")

    def test_maps_traced_by_other_shaders_are_refused(self):
        self.save()
        shaders = self.folder / "shaders"
        shutil.copytree(Setup.source / "shaders", shaders)
        self.succeed("render", "ball.yaml", "--load-photons", "maps", "-o", "b.exr", "--shaders", "shaders")
        # Code that estimates from photons may change, code that traces them may not
        for kernel, traces in {"estimate_radiance": False, "scatter_photon": True}.items():
            with self.subTest(kernel):
                file = shaders / "kernels" / f"{kernel}.comp"
                file.write_text(file.read_text() + "// edited\n")
                if traces:
                    self.assert_not_loaded("the hash of the GLSL that traces photons is ", "ball.yaml",
                                           "--shaders", "shaders")
                else:
                    self.succeed("render", "ball.yaml", "--load-photons", "maps", "-o", "b.exr", "--shaders", "shaders")

    def test_maps_traced_with_other_code_of_the_scene_are_refused(self):
        self.write("own.yaml", BALL.replace("passes: 1", "passes: 1, filter: custom, filter_file: even.glsl")
                   .replace("materials: {floor: {type: diffuse}",
                            "textures: {own: {type: custom, file: own.glsl}}\n"
                            "materials: {floor: {type: diffuse, albedo: {texture: own}}"))
        texture = "vec3 own(vec3 position, vec2 uv, vec4 parameters) { return vec3(%s); }\n"
        self.write("own.glsl", texture % "0.5")
        self.write("even.glsl", "float even(float u) { return 1.0; }\n")
        self.save("own.yaml")
        self.write("even.glsl", "float even(float u) { return 2.0; }\n")
        self.succeed("render", "own.yaml", "--load-photons", "maps", "-o", "b.exr")
        self.write("own.glsl", texture % "0.25")
        self.assert_not_loaded("the hash of the GLSL that traces photons is ", "own.yaml")

    def test_maps_of_an_earlier_version_of_the_file_are_refused_as_such(self):
        self.save()
        content = (self.folder / "maps").read_bytes()
        self.write("maps", b"hyaphot1" + content[8:])
        self.assert_refused(BAD_INPUT, ["maps: the photon maps are from an earlier version of the program",
                                        "write it again with --save-photons"],
                            ["render", "ball.yaml", "--load-photons", "maps", "-o", "b.exr"])

    def test_damaged_maps_are_refused(self):
        self.succeed("render", "ball.yaml", "--save-photons", "maps", "-o", "a.exr")
        good = (self.folder / "maps").read_bytes()
        flipped = bytearray(good)
        flipped[len(good) // 2] ^= 1
        greedy = bytearray(good)
        greedy[16:24] = struct.pack("<Q", 1 << 60)
        wordy = bytearray(good)
        wordy[8:16] = struct.pack("<Q", 1 << 60)
        for damage, content in {"cut": good[:-40], "flipped": flipped, "greedy": greedy, "wordy": wordy, "short": b"hya",
                                "other": b"x" * 500, "none": b""}.items():
            with self.subTest(damage):
                self.write("bad", bytes(content))
                self.assert_refused(BAD_INPUT, ["bad"], ["render", "ball.yaml", "--load-photons", "bad", "-o", "b.exr"])
        self.assert_refused(BAD_INPUT, ["nowhere"], ["render", "ball.yaml", "--load-photons", "nowhere", "-o", "b.exr"])

    def test_only_photonmap_on_the_device_has_maps_to_save(self):
        for option in ("--save-photons", "--load-photons"):
            self.assert_refused(USAGE, ["photonmap"], ["render", "ball.yaml", option, "maps", "--integrator", "ppm",
                                                       "-o", "b.exr"])
            self.assert_refused(USAGE, ["reference", option], ["render", "ball.yaml", option, "maps",
                                                               "--backend", "reference", "-o", "b.exr"])


class Views(CliTest):
    def setUp(self):
        super().setUp()
        self.write("ball.yaml", BALL)

    def test_the_layers_add_up_to_the_picture(self):
        names = ("emitted", "direct", "caustic", "indirect")
        for backend in ("vulkan", "reference"):
            self.succeed("render", "ball.yaml", "--layers", "--backend", backend, "-o", "a.exr")
            picture = Picture(self.folder / "a.exr")
            layers = [Picture(self.folder / "a.exr", layer=name) for name in names]
            for y in range(16):
                for x in range(16):
                    for channel in range(3):
                        total = sum(layer.at(x, y)[channel] for layer in layers)
                        self.assertAlmostEqual(picture.at(x, y)[channel], total, delta=1e-6 * (1 + total))
            self.assertGreater(max(layers[1].values()), 0)
            self.assertGreater(max(layers[2].values()), 0)

    def test_every_view_shows_something_of_its_own(self):
        pictures = {}
        for view in ("picture", "global_map", "caustic_map", "photons", "radius"):
            self.succeed("render", "ball.yaml", "--set", f"render.view={view}", "-o", f"{view}.exr")
            pictures[view] = Picture(self.folder / f"{view}.exr").values()
            self.assertGreater(max(pictures[view]), 0, view)
        self.assertEqual(len({tuple(values) for values in pictures.values()}), 5)

    def test_layers_need_a_file_that_can_hold_them(self):
        self.assert_refused(USAGE, ["--layers", ".exr"], ["render", "ball.yaml", "--layers", "-o", "a.png"])
        self.assert_refused(USAGE, ["--layers", "no layers", "two passes"],
                            ["render", "ball.yaml", "--layers", "--integrator", "whitted", "--passes", "1", "-o", "a.exr"])


class Warnings(CliTest):
    def warning(self, scene, *options):
        self.write("scene.yaml", scene)
        result = self.run_program("render", "scene.yaml", "-o", "a.png", *options)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stderr

    def test_targets_that_no_light_reaches_are_reported(self):
        # A lid between the light and the ball
        lid = BALL + "  - {shape: {type: quad, corner: [-3, 2, -3], edges: [[0, 0, 6], [6, 0, 0]]}, material: floor}\n"
        self.assertIn("caustic photons", self.warning(lid))
        self.assertEqual(self.warning(BALL), "")

    def test_lights_that_shine_into_nothing_are_reported(self):
        self.assertIn("no photon landed", self.warning(BALL.replace("[0, 3, 0]", "[0, -30, 0]").replace("floor}", "glass}")))

    def test_too_few_photons_for_an_estimate_are_reported(self):
        self.assertIn("fewer than", self.warning(BALL, "--photons", "20"))

    def test_numbers_out_of_range_are_refused_with_their_place(self):
        for setting, value in {"nearest": 1, "caustic_nearest": 513, "photons": 0, "caustic_photons": -1,
                               "caustic_radius": -2, "radius": -1, "gather_rays": 5000, "cone_constant": 0.5,
                               "shadow_photons": 65, "structure": "tree", "filter": "box", "view": "all"}.items():
            with self.subTest(setting):
                self.write("scene.yaml", BALL.replace("passes: 1", f"passes: 1, {setting}: {value}")
                           if setting not in ("photons", "caustic_photons")
                           else BALL.replace(f" {setting}: 2000", f" {setting}: {value}"))
                self.assert_refused(BAD_INPUT, ["scene.yaml:3:", setting],
                                    ["render", "scene.yaml", "-o", "a.png"])

    def test_a_single_pass_has_layers_where_the_picture_is_a_sum_of_them(self):
        self.write("ball.yaml", BALL)
        single = ["render", "ball.yaml", "--passes", "1", "--layers", "-o", "a.exr"]
        self.succeed(*single, "--integrator", "path")
        picture = Picture(self.folder / "a.exr")
        met, sampled = (Picture(self.folder / "a.exr", layer=name) for name in ("met", "sampled"))
        for y in range(16):
            for x in range(16):
                for channel in range(3):
                    total = met.at(x, y)[channel] + sampled.at(x, y)[channel]
                    self.assertAlmostEqual(picture.at(x, y)[channel], total, delta=1e-6 * (1 + total))
        self.assertGreater(max(sampled.values()), 0)
        self.assert_refused(USAGE, ["--layers", "no layers", "reference: photonmap;"],
                            [*single, "--integrator", "path", "--backend", "reference"])
        self.assert_refused(USAGE, ["--layers", "no layers"], [*single, "--set", "render.view=caustic_map"])
