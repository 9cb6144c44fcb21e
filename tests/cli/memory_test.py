"""Device memory of a render: as docs/performance.md states, and an error before work starts if it does not fit."""

import re

from program import DEVICE, CliTest, Setup


def documented():
    """Bytes by purpose, from the table of docs/performance.md: | `ppm`, a pixel | 123 | …"""
    text = (Setup.source / "docs/performance.md").read_text()
    section = text.split("## Memory\n")[1].split("\n## ")[0]
    return {name: float(value) for name, value in re.findall(r"^\| ([^|]+?) \| ([\d.]+) \|", section, re.M)}


class Memory(CliTest):
    def bytes_of(self, scene, *options):
        report = self.succeed_json("render", scene, "--passes", "1", "-o", "a.png", *options)
        return sum(report["buffer_bytes"].values())

    def assert_like(self, name, measured, tolerance=0.01):
        self.assertIn(name, documented())
        self.assertAlmostEqual(measured / documented()[name], 1, delta=tolerance, msg=f"{name}: {measured}")

    def test_a_pixel_takes_what_the_documentation_says(self):
        sides = 32, 128
        for integrator in ("ppm", "photonmap", "path", "whitted"):
            with self.subTest(integrator):
                few, many = (
                    self.bytes_of(self.write("a.yaml", SCENE), "--integrator", integrator, "--photons", "500",
                                  "--resolution", f"{side}x{side}", "--max-depth", "3")
                    for side in sides
                )
                self.assert_like(f"`{integrator}`, a pixel", (many - few) / (sides[1] ** 2 - sides[0] ** 2), 0.05)

    def test_a_photon_in_flight_takes_what_the_documentation_says(self):
        few, many = (self.report_of_photons(count) for count in (10000, 50000))
        queue = ("photon rays", "photon hits", "photon next rays", "photon alive", "photon offsets", "photon paths",
                 "next photon paths")
        in_flight = sum(many[name] - few[name] for name in queue)
        self.assert_like("a photon in flight", in_flight / 40000)

    def report_of_photons(self, count):
        options = ["--resolution", "8x8", "--photons", count, "--passes", "1", "-o", "a.png"]
        return self.succeed_json("render", self.write("a.yaml", SCENE), *options)["buffer_bytes"]

    def test_a_triangle_takes_what_the_documentation_says(self):
        few, many = (self.write(f"{level}.yaml", SCENE.replace("level: 4", f"level: {level}")) for level in (10, 20))
        counts = [self.succeed_json("bench", scene, "--stage", "camera", "--runs", "1")["scenes"][0]["triangles"]
                  for scene in (few, many)]
        sizes = [self.bytes_of(scene, "--resolution", "8x8", "--photons", "100") for scene in (few, many)]
        # The number of triangles per node depends on the mesh
        self.assert_like("a triangle with normals", (sizes[1] - sizes[0]) / (counts[1] - counts[0]), 0.05)

    def test_what_does_not_fit_is_refused_before_work_starts(self):
        self.assert_refused(DEVICE, ["no device memory for", "MiB", "lower the resolution"],
                            ["render", self.write("a.yaml", SCENE), "--resolution", "16384x16384", "-o", "a.png"])


SCENE = """hyalite: 1
camera: {position: [0, 3, 7], look_at: [0, 1.4, 0], resolution: [32, 32]}
render: {caustic_photons: 0, radius: 0.1}
materials: {gray: {type: diffuse}}
objects:
  - {shape: {type: teapot, level: 4}, material: gray}
  - {shape: {type: quad, corner: [-2, 6, -2], edges: [[4, 0, 0], [0, 0, 4]]}, emission: 8}
"""
