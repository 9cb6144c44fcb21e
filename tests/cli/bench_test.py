"""hyalite bench: what it measures, and that its rays hit what a native tracer hits."""

from program import USAGE, CliTest, Setup

RAYS = ["camera", "shadow", "bounce", "shuffled"]


class Bench(CliTest):
    def bench(self, *arguments):
        return self.succeed_json("bench", *arguments)

    def stages(self, *arguments):
        """The stages of the only scene, by name."""
        (scene,) = self.bench(*arguments)["scenes"]
        return {stage["stage"]: stage for stage in scene["stages"]}

    def small_scene(self):
        """64 x 64 pixels on a floor under an area light: only triangles and quads, which the native tracer supports."""
        return self.write(
            "floor.yaml",
            """hyalite: 1
camera: {position: [0, 3, 7], look_at: [0, 1.4, 0], resolution: [64, 64]}
materials: {gray: {type: diffuse}}
objects:
  - {shape: {type: teapot, level: 4}, material: gray}
  - {shape: {type: teapot, level: 4}, material: gray, transform: [{translate: [4, 0, -2]}]}
  - {shape: {type: quad, corner: [-9, 0, -9], edges: [[0, 0, 18], [18, 0, 0]]}, material: gray}
  - {shape: {type: quad, corner: [-2, 6, -2], edges: [[4, 0, 0], [0, 0, 4]]}, emission: 8}
""",
        )

    def test_every_stage_of_a_scene_is_measured_once(self):
        stages = self.stages(self.small_scene(), "--runs", "3", "--photons", "2000", "--stage", *RAYS,
                             "scene", "photons", "grid", "gather", "tree", "estimate", "start", "render")
        self.assertEqual(
            list(stages),
            ["scene", "camera", "shadow", "bounce", "shuffled", "photons", "grid", "gather", "tree", "estimate",
             "start", "render"],
        )
        for name, stage in stages.items():
            with self.subTest(name):
                self.assertGreater(stage["count"], 0)
                self.assertGreater(stage["fastest"], 0)
                self.assertLessEqual(stage["fastest"], stage["seconds"])
                self.assertLessEqual(stage["seconds"], stage["slowest"])
                self.assertAlmostEqual(stage["per_second"] * stage["seconds"] / stage["count"], 1, places=6)
        # One camera ray per pixel, and the same rays in order and shuffled
        self.assertEqual(stages["camera"]["count"], 64 * 64)
        self.assertEqual(stages["bounce"]["count"], stages["shuffled"]["count"])

    def test_rays_end_where_the_native_tracer_says(self):
        report = self.bench(self.small_scene(), "--runs", "1", "--stage", *RAYS)
        if not report["native"]:
            self.fail("built without Embree: run scripts/install-deps.sh test, and build again")
        for stage in report["scenes"][0]["stages"]:
            with self.subTest(stage["stage"]):
                (rival,) = stage["rivals"]
                self.assertEqual(rival["name"], report["native"])
                self.assertGreater(rival["ratio"], 0)
                # Rays that pass a silhouette within rounding may differ: 1e-6 over a pixel width of 1e-2, about one in
                # ten thousand. Embree is not watertight: a few more slip through edges.
                self.assertGreaterEqual(rival["agreeing"], 0.999)

    def test_other_shaders_are_measured_by_turns_and_find_the_same(self):
        stages = self.stages("csg", "--runs", "1", "--stage", "camera", "--against", Setup.source / "shaders")
        (rival,) = stages["camera"]["rivals"]  # Embree does not support solids
        self.assertEqual((rival["name"], rival["agreeing"]), ("other shaders", 1))

    def test_kernels_are_compiled_one_by_one(self):
        report = self.bench("--stage", "kernels")
        self.assertEqual(report["scenes"], [])
        names = [kernel["kernel"] for kernel in report["kernels"]]
        self.assertEqual(names, sorted(path.stem for path in (Setup.source / "shaders/kernels").glob("*.comp")))
        self.assertTrue(all(kernel["compile_seconds"] > 0 for kernel in report["kernels"]))

    def test_what_cannot_be_measured_is_refused(self):
        self.assert_refused(USAGE, ["nonsense"], ["bench", "--stage", "nonsense"])
        self.assert_refused(USAGE, ["--runs"], ["bench", "--runs", "0"])
        self.assert_refused(USAGE, ["not a folder of shaders"], ["bench", "--against", "."])
