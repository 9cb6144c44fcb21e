"""Same scene, same seed, same driver: the same bytes, on every run, for any number of threads and any SIMD width."""

from exr import Picture
from program import CliTest, scene_file


class Determinism(CliTest):
    # Scene and integrator of the compared pictures.
    SUBJECTS = (
        ("cornell-caustics.yaml", "ppm"),
        ("tests/mesh-room.yaml", "ppm"),
        ("tests/all-shapes.yaml", "ppm"),
        ("tests/all-lights.yaml", "ppm"),
        ("tests/all-lights.yaml", "whitted"),
        ("globe.yaml", "ppm"),
        ("cornell-caustics.yaml", "photonmap"),
        ("tests/all-materials.yaml", "photonmap"),
    )
    # Environment variables of lavapipe, which falls back to a smaller width that the CPU supports.
    ENVIRONMENTS = (
        {},
        {},
        {"LP_NUM_THREADS": "1"},
        {"LP_NUM_THREADS": "2"},
        {"LP_NATIVE_VECTOR_WIDTH": "128"},
        {"LP_NATIVE_VECTOR_WIDTH": "256"},
        {"LP_NATIVE_VECTOR_WIDTH": "512"},
    )

    def render(self, scene, integrator, environment):
        # lavapipe by name: only it reads these variables.
        options = ["--integrator", integrator, "--resolution", "64x64", "--passes", "3", "--photons", "20000",
                   "--set", "render.caustic_photons=20000", "--set", "render.shadow_photons=4"]
        arguments = ["render", scene_file(scene), *options, "--device", "llvmpipe", "-o", "picture.exr"]
        report = self.succeed_json(*arguments, environment=environment)
        return (self.folder / "picture.exr").read_bytes(), report["device"]

    def test_runs_threads_and_widths_do_not_change_a_byte(self):
        for scene, integrator in self.SUBJECTS:
            first, _ = self.render(scene, integrator, {})
            self.assertGreater(max(Picture(self.folder / "picture.exr").values()), 0, "the picture is black")
            for environment in self.ENVIRONMENTS[1:]:
                with self.subTest(scene=scene, integrator=integrator, environment=environment):
                    picture, device = self.render(scene, integrator, environment)
                    self.assertTrue(picture == first, "the bytes differ")
                    if environment.get("LP_NATIVE_VECTOR_WIDTH") == "128":  # supported by every CPU
                        self.assertIn("128 bits", device, "the variable had no effect")

    def test_each_width_compiles_its_own_code(self):
        """Mesa's cache would return code compiled for another width, which calls functions of this one: a crash, or no real test."""
        cache = self.folder / "cache"
        for width in ("256", "128"):
            environment = {"XDG_CACHE_HOME": str(cache), "LP_NATIVE_VECTOR_WIDTH": width}
            self.render("tests/all-shapes.yaml", "ppm", environment)
            compiled = [path for path in (cache / f"hyalite/driver-width-{width}").rglob("*") if path.is_file()]
            self.assertGreater(sum(path.stat().st_size for path in compiled), 100_000)
        self.assertFalse((cache / "mesa_shader_cache").exists() or (cache / "mesa_shader_cache_db").exists())
