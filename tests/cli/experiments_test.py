"""Features for experiments: a scene's own GLSL, and arrays of stages for NumPy."""

import ast
import signal
import stat
import struct
import subprocess

from program import BAD_INPUT, DEVICE, SCENE, TIMEOUT, USAGE, CliTest, Setup, command_line, default_environment

TEXTURED = SCENE.replace("materials:", "textures: {t: {type: custom, file: %s, parameters: [2, 0.5]}}\nmaterials:").replace(
    "{type: diffuse}", "{type: diffuse, albedo: {texture: t}}"
)
FILTERED = SCENE.replace("photons: 100", "photons: 100, integrator: photonmap, gather_rays: 0, filter: custom, filter_file: f.glsl")


def read_npy(path):
    """Header and data of a NumPy file of version 1."""
    content = path.read_bytes()
    assert content[:8] == b"\x93NUMPY\x01\x00", content[:8]
    (length,) = struct.unpack("<H", content[8:10])
    assert (10 + length) % 64 == 0, length
    return ast.literal_eval(content[10 : 10 + length].decode()), content[10 + length :]


class CustomCode(CliTest):
    def render(self, scene, *options):
        self.write("scene.yaml", scene)
        self.succeed("render", "scene.yaml", "--quiet", "-o", "out.exr", *options)
        return (self.folder / "out.exr").read_bytes()

    def test_a_texture_in_glsl_is_what_it_returns(self):
        # The parameters give 0.25 everywhere: the same picture as a plain albedo of 0.25
        self.write("quarter.glsl", "vec3 quarter(vec3 p, vec2 uv, vec4 k) { return vec3(k.y / k.x); }\n")
        custom = self.render(TEXTURED % "quarter.glsl")
        plain = self.render(SCENE.replace("{type: diffuse}", "{type: diffuse, albedo: 0.25}"))
        self.assertEqual(custom, plain)

    def test_what_it_returns_is_cut_to_shares_of_the_light(self):
        self.write("more.glsl", "vec3 more(vec3 p, vec2 uv, vec4 k) { return vec3(7.0, -1.0, 1.0); }\n")
        custom = self.render(TEXTURED % "more.glsl")
        self.assertEqual(custom, self.render(SCENE.replace("{type: diffuse}", "{type: diffuse, albedo: [1, 0, 1]}")))

    def test_a_filter_in_glsl_weighs_the_photons(self):
        scene = FILTERED.replace("objects: [", "objects: [{shape: {type: quad, corner: [-3, -1, -3], edges: [[0, 0, 6], [6, 0, 0]]}, material: gray}, ")
        scene = scene.replace("photons: 100", "photons: 5000")
        self.write("f.glsl", "float f(float u) { return 2.0; }\n")
        even = self.render(scene)  # divided by its mean, a constant filter has no effect; a power of two causes no rounding
        self.assertEqual(even, self.render(scene.replace("filter: custom, filter_file: f.glsl", "filter: none")))
        self.write("f.glsl", "float f(float u) { return 1.0 - u; }\n")
        self.assertNotEqual(self.render(scene), even)

    def test_a_material_in_glsl_reflects_what_it_returns(self):
        # 0.25 at every angle is a smooth mirror of reflectance 0.25; the same function serves two materials
        objects = "{shape: {type: quad, corner: [-3, -1, -3], edges: [[0, 0, 6], [6, 0, 0]]}, material: %s}, "
        scene = SCENE.replace("objects: [", "objects: [" + objects % "own")
        self.write("share.glsl", "vec3 share(float cosine, vec4 k) { return vec3(k.x, k.y, 2.0 * cosine - 9.0); }\n")
        own = self.render(scene.replace("materials: {", "materials: {other: {type: custom, file: share.glsl, parameters: [1]}, "
                                        "own: {type: custom, file: share.glsl, parameters: [0.25, 0.5]}, "))
        mirror = self.render(scene.replace("materials: {", "materials: {own: {type: mirror, reflectance: [0.25, 0.5, 0]}, "))
        self.assertEqual(own, mirror)

    def test_a_mistake_in_the_code_is_reported_at_its_line(self):
        self.write("scene.yaml", TEXTURED % "bad.glsl")
        self.write("bad.glsl", "\nvec3 bad(vec3 p, vec2 uv, vec4 k) {\n    return missing;\n}\n")
        self.assert_refused(BAD_INPUT, ["bad.glsl:3: ", "missing"], ["render", "scene.yaml"])

    def test_a_twin_is_used_for_the_very_code_that_it_was_written_after(self):
        self.write("marble.glsl", (Setup.source / "scenes/experiments/marble.glsl").read_bytes())
        scene = TEXTURED % "marble.glsl"
        self.render(scene, "--backend", "reference")
        code = self.folder / "marble.glsl"
        line = 1 + code.read_text()[: code.read_text().index("vec3 marble(")].count("\n")
        code.write_text(code.read_text().replace("vein * vein", "vein"))
        self.assert_refused(USAGE, [f"marble.glsl:{line}: there is no twin of 'marble': ", "marble.twin.so is the twin of other code"],
                            ["render", "scene.yaml", "--backend", "reference"])
        result = self.run_program("parity", "scene.yaml", "--resolution", "8x8")
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("shade_surface has no twin to compare with: it runs the scene's own marble.glsl", result.stdout)

    def test_every_shipped_twin_is_of_the_code_beside_it(self):
        folder = Setup.source / "scenes/experiments"
        twins = sorted(folder.glob("*.twin.cpp"))
        self.assertEqual([twin.name for twin in twins], ["marble.twin.cpp", "oil.twin.cpp"])
        for twin in twins:
            code_hash = 0xCBF29CE484222325
            for byte in (folder / twin.name.replace(".twin.cpp", ".glsl")).read_bytes():
                code_hash = (code_hash ^ byte) * 0x100000001B3 % 2**64
            self.assertIn(f".codeHash = 0x{code_hash:016x}", twin.read_text(), twin.name)

    def test_a_twin_can_be_named(self):
        self.write("marble.glsl", (Setup.source / "scenes/experiments/marble.glsl").read_bytes())
        shipped = Setup.program.parent.parent / "scenes/experiments/marble.twin.so"
        own = self.write("own.so", shipped.read_bytes())
        plain = self.render(TEXTURED % "marble.glsl", "--backend", "reference")
        self.assertEqual(self.render(TEXTURED % "marble.glsl", "--backend", "reference", "--twins", own), plain)
        self.write("text.so", "no shared object\n")
        for twin, words in (("gone.so", ["gone.so: cannot load the twin: "]), ("text.so", ["text.so: cannot load the twin: "])):
            for command in (["render", "scene.yaml", "--backend", "reference"], ["parity", "scene.yaml"]):
                self.assert_refused(USAGE, words, [*command, "--twins", twin])
        self.assert_refused(USAGE, ["--backend vulkan does not support --twins"], ["render", "scene.yaml", "--twins", own])

    def test_the_reference_and_parity_say_that_there_is_no_twin(self):
        self.write("quarter.glsl", "vec3 quarter(vec3 p, vec2 uv, vec4 k) { return vec3(0.25); }\n")
        self.write("scene.yaml", TEXTURED % "quarter.glsl")
        self.assert_refused(USAGE, ["quarter.glsl", "no twin"], ["render", "scene.yaml", "--backend", "reference"])
        result = self.run_program("parity", "scene.yaml", "--resolution", "8x8")
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("shade_surface has no twin to compare with: it runs the scene's own quarter.glsl", result.stdout)
        # Stages that do not run the code are still compared
        self.assertRegex(result.stdout, r"trace_closest .* passed")


class Dumps(CliTest):
    def setUp(self):
        super().setUp()
        self.write("scene.yaml", SCENE)

    def test_an_array_of_records_and_a_member_of_it_come_as_numpy_files(self):
        # One ray per pixel of 8 x 8, from the camera at (0, 0, 4)
        self.succeed("render", "scene.yaml", "--quiet", "--dump", "generate_camera_rays:rays", "--dump", "generate_camera_rays:rays.origin",
                     "--dump", "trace_closest:hits.object")
        header, data = read_npy(self.folder / "generate_camera_rays.rays.npy")
        self.assertEqual(header["shape"], (64,))
        self.assertFalse(header["fortran_order"])
        self.assertEqual(header["descr"], [("origin", "<f4", (3,)), ("tMax", "<f4"), ("direction", "<f4", (3,)), ("from", "<u4")])
        self.assertEqual(len(data), 64 * 32)
        header, origins = read_npy(self.folder / "generate_camera_rays.rays.origin.npy")
        self.assertEqual((header["descr"], header["shape"]), ("<f4", (64, 3)))
        self.assertEqual(origins, struct.pack("<3f", 0, 0, 4) * 64)
        header, objects = read_npy(self.folder / "trace_closest.hits.object.npy")
        # The central rays hit the only object; the corner rays miss the sphere
        self.assertEqual(struct.unpack("<64I", objects)[8 * 4 + 4], 0)
        self.assertEqual(struct.unpack("<64I", objects)[0], 0xFFFFFFFF)

    def test_a_later_dispatch_can_be_asked_for(self):
        self.succeed("render", "scene.yaml", "--quiet", "--passes", 2, "--dump", "resolve_film:image@1")
        self.assertEqual(read_npy(self.folder / "resolve_film.image.1.npy")[0]["shape"], (64, 3))

    def test_what_is_not_there_is_refused_with_what_is(self):
        for dump, words in (
            ("trace_closest", ["STAGE:FIELD"]),
            ("trace_closest:hit", ["'trace_closest' has no array 'hit'", "hits"]),
            ("trace_closest:hits.x", ["'Hit' has no member 'x'", "object"]),
            ("trace_closest:count", ["no array"]),
            ("trace_nearest:hits", ["trace_nearest", "trace_closest"]),
            ("trace_closest:hits@x", ["'x' is not a dispatch number"]),
            ("resolve_film:image@99", ["4 times"]),
            ("../trace_closest:hits", ["'/'"]),
        ):
            with self.subTest(dump=dump):
                self.assert_refused(USAGE, words, ["render", "scene.yaml", "-o", "out.png", "--dump", dump])
        self.assert_refused(USAGE, ["--dump"], ["render", "scene.yaml", "--backend", "reference", "--dump", "trace_closest:hits"])


class LivePage(CliTest):
    """Requests that hyalite live refuses, and files it leaves behind; tests/browser/live_test.py tests its functions."""

    def test_who_has_no_home_has_a_cache_that_nobody_else_can_reach(self):
        self.write("scene.yaml", SCENE)
        temporary = self.folder / "temporary"
        temporary.mkdir()
        environment = {name: value for name, value in default_environment().items() if name not in ("HOME", "XDG_CACHE_HOME")}
        server = subprocess.Popen(command_line(["live", "scene.yaml", "--port", "0"]), cwd=self.folder, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, env={**environment, "TMPDIR": str(temporary)}, text=True)
        try:
            self.assertIn("http://", server.stdout.readline())
            (folder,) = temporary.iterdir()
            self.assertEqual(stat.S_IMODE(folder.stat().st_mode), 0o700)
            self.assertRegex(folder.name, "^hyalite-[A-Za-z0-9]{6}$")
            self.assertNotEqual(folder.name, f"hyalite-{server.pid}")  # a number that is visible could have been planted by someone else
            server.send_signal(signal.SIGINT)
            self.assertEqual(server.wait(TIMEOUT), 0)
        finally:
            server.kill()
            server.communicate()
        self.assertEqual(list(temporary.iterdir()), [])

    def test_what_cannot_be_served_is_refused_before_it_is(self):
        self.write("scene.yaml", SCENE)
        self.assert_refused(BAD_INPUT, ["gone.yaml"], ["live", "gone.yaml"])
        self.assert_refused(DEVICE, ["teapot"], ["live", "scene.yaml", "--device", "teapot"])
        for options, words in (
            (["--port", "70000"], ["--port"]),
            (["--limit", "0"], ["--limit"]),
            (["--shaders", "."], ["not a folder of shaders"]),
            (["--host", "203.0.113.7", "--port", "0"], ["cannot listen at 203.0.113.7"]),  # not an address of this machine
            (["--set", "render.passes"], ["no value"]),
        ):
            with self.subTest(options=options):
                self.assert_refused(USAGE, words, ["live", "scene.yaml", *options])
