"""Every shipped scene renders, and the test scenes have the radiance derived in their headers."""

import math

from exr import Picture
from program import CliTest, Setup, scene_file


class EveryScene(CliTest):
    def test_every_scene_renders_to_a_picture_of_finite_radiance(self):
        scenes = sorted((Setup.source / "scenes").rglob("*.yaml"))
        self.assertGreaterEqual(len(scenes), 5, scenes)
        for scene in scenes:
            with self.subTest(scene.name):
                options = ["--resolution", "32x32", "--passes", "2", "--photons", "5000", "--quiet", "-o", "a.exr",
                           "--set", "render.caustic_photons=5000"]
                self.succeed("render", str(scene), *options)
                picture = Picture(self.folder / "a.exr")
                self.assertEqual((picture.width, picture.height), (32, 32))
                self.assertTrue(picture.is_finite())
                self.assertGreaterEqual(min(picture.values()), 0)
                is_black = "accept: [unseen-light, black-picture]" in scene.read_text()
                self.assertEqual(max(picture.values()) > 0, not is_black)
                # The program's own reader agrees; it refuses pictures with NaN.
                self.assertEqual(self.succeed_json("compare", "a.exr", "a.exr")["rmse"], 0)


class KnownAnswers(CliTest):
    BACKENDS = ("vulkan", "reference")

    def render(self, name, backend, *options):
        arguments = ["render", scene_file(name), "--backend", backend, *options, "--quiet", "-o", "a.exr"]
        self.succeed(*arguments)
        return Picture(self.folder / "a.exr")

    # point-light-floor.yaml: camera at (0, 3, 4) looking at the origin, vertical field of view 40 degrees, 65 x 65.
    SIDE = 65

    def floor_radiance(self, column, row):
        """Radiance through the point (column, row) of the picture, in pixels from its upper left corner."""
        half = math.tan(math.radians(20))
        x = half * (2 * column / self.SIDE - 1)
        y = half * (1 - 2 * row / self.SIDE)
        # The view direction is (0, -3, -4)/5, right is (1, 0, 0), up is (0, 4, -3)/5.
        direction = (x, (-3 + 4 * y) / 5, (-4 - 3 * y) / 5)
        distance = 3 / -direction[1]  # always downwards: the upper edge is 36.9 - 20 degrees below the horizon
        floor_x, floor_z = distance * direction[0], 4 + distance * direction[2]
        if max(abs(floor_x), abs(floor_z)) > 5:
            return 0.0  # beside the floor
        # The scene's header: 0.5/pi * 10 * 2 / (x^2 + z^2 + 4)^(3/2).
        return 10 / math.pi / (floor_x**2 + floor_z**2 + 4) ** 1.5

    def range_in_pixel(self, column, row):
        """Smallest and largest radiance over a pixel. It falls with the distance from the origin, so the extremes lie on the
        pixel's border or, for the central pixel, in its centre; a grid of 9 x 9 points finds them to 0.1 %."""
        seen = [self.floor_radiance(column + i / 8, row + j / 8) for i in range(9) for j in range(9)]
        return 0.999 * min(seen), 1.001 * max(seen)

    def test_the_floor_under_a_point_light_has_the_radiance_of_the_closed_form_in_every_pixel(self):
        # Wherever the samples lie in their pixel, their mean lies between the extremes over the pixel.
        expected = {(x, y): self.range_in_pixel(x, y) for x in range(self.SIDE) for y in range(self.SIDE)}
        # Without a second surface there is no indirect light, so photon mapping gives the same result.
        whitted, ppm = ["--passes", "2"], ["--passes", "2", "--photons", "5000", *self.ppm_settings()]
        cases = [("point-light-floor.yaml", whitted), ("point-light-floor.yaml", ppm), ("far-floor.yaml", whitted)]
        for backend in self.BACKENDS:
            for name, options in cases:
                with self.subTest(name, backend=backend, options=options):
                    picture = self.render("tests/" + name, backend, *options)
                    outside = [
                        (pixel, least, picture.at(*pixel), largest)
                        for pixel, (least, largest) in expected.items()
                        if not all(least <= value <= largest for value in picture.at(*pixel))
                    ]
                    self.assertEqual(outside[:5], [], f"{len(outside)} pixels: (place, least, found, largest)")
                    # The header's number; over the pixel radiance falls by 0.11 %: at its rim, at most 0.054 m from
                    # the origin, it is (1 + 0.054^2 / 4)^(-3/2) = 0.9989 of it.
                    for value in picture.at(32, 32):
                        self.assertAlmostEqual(value, 5 / (4 * math.pi), delta=0.0012 * 5 / (4 * math.pi))

    def test_a_ground_of_a_hundred_metres_has_one_radiance_in_every_pixel_from_five_centimetres(self):
        for backend in self.BACKENDS:
            with self.subTest(backend):
                values = self.render("tests/csg-ground.yaml", backend).values()
                self.assertAlmostEqual(min(values), 1.2 / math.pi, delta=1e-5)
                self.assertAlmostEqual(max(values), 1.2 / math.pi, delta=1e-5)

    def test_a_ball_has_the_mean_radiance_of_lamberts_law_from_ten_kilometres(self):
        # 16 384 samples, one for each cell of a grid, find the area of a disk across 58 pixels to 0.5 %.
        for backend in self.BACKENDS:
            with self.subTest(backend):
                values = list(self.render("tests/ball-from-afar.yaml", backend).values())
                self.assertAlmostEqual(sum(values) / len(values), 0.33058, delta=0.01 * 0.33058)

    @staticmethod
    def ppm_settings():
        return ["--set", "render.max_depth=2", "--set", "render.integrator=ppm"]

    def test_straight_through_a_glass_slab_a_light_has_the_transmitted_radiance(self):
        # The scene's header: 1.3 (1 - R) / (1 + R) with R = 0.04 is 1.2. Off the axis by an angle of up to
        # 0.22 degrees (the corner of a pixel) the Fresnel terms change by the order of the angle's square, 1.5e-5.
        for backend in self.BACKENDS:
            with self.subTest(backend):
                picture = self.render("tests/glass-slab.yaml", backend, "--passes", "2")
                for value in picture.at(32, 32):
                    self.assertAlmostEqual(value, 1.2, delta=1.2 * 1e-4)
