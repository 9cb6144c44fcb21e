"""Bad input: each mistake gives the right exit code and one clear line on stderr, and leaves no file behind."""

import functools
import os
import resource
import shutil

from program import BAD_INPUT, DEVICE, OUTPUT, SCENE, USAGE, CliTest, Setup


class Refusals(CliTest):
    """A table of cases is a dictionary: mistake -> arguments, and the words required in the message."""

    def assert_all_refused(self, code, cases, **options):
        self.write("scene.yaml", SCENE)
        for name, (arguments, *words) in cases.items():
            with self.subTest(name):
                self.assert_refused(code, words, arguments, **options)


class SceneFiles(Refusals):
    def assert_place_refused(self, part, marked, *words):
        """Replaces part of the valid scene. The dollar sign in `marked` is the place of the mistake."""
        self.assertIn(part, SCENE)
        text = SCENE.replace(part, marked)
        before = text[: text.index("$")]
        line, column = before.count("\n") + 1, len(before) - before.rfind("\n")
        self.write("scene.yaml", text.replace("$", ""))
        with self.subTest(marked):
            self.assert_refused(BAD_INPUT, [f"scene.yaml:{line}:{column}: ", *words], ["render", "scene.yaml"])

    def test_the_scene_without_a_mistake_renders(self):
        self.write("scene.yaml", SCENE)
        self.succeed("render", "scene.yaml", "--quiet")

    def test_a_file_that_cannot_be_a_scene_is_refused(self):
        self.write("empty.yaml", "")
        self.write("binary.yaml", bytes(range(256)))
        self.write("folder/in.txt", "")
        self.assert_all_refused(BAD_INPUT, {
            "missing": (["render", "none.yaml"], "none.yaml", "no such file"),
            "empty": (["render", "empty.yaml"], "empty.yaml", "empty"),
            "a folder": (["render", "folder"], "folder", "it is a folder"),
            "bytes that are no text": (["render", "binary.yaml"], "binary.yaml"),
            "a device": (["render", os.devnull], os.devnull, "not a regular file"),
            "no name": (["render", ""], "no such file"),
        })  # fmt: skip

    def test_a_mistake_in_a_scene_is_reported_with_its_place(self):
        refused = self.assert_place_refused
        refused("[8, 8]", "[8, 8$}", "YAML")
        refused("photons: 100", "$fotons: 100", "'fotons'", "did you mean 'photons'?")
        refused("type: sphere", "type: $spere", "'spere'", "did you mean 'sphere'?")
        refused("material: gray", "material: $grey", "'grey'", "did you mean 'gray'?")
        refused("passes: 1", "passes: $many", "'passes'", "whole number", "'many'")
        refused("[0, 1, 2]", "$0", "'position'", "3 numbers")
        refused("[0, 1, 2]", "[0, $.nan, 2]", "'position'", "nan")
        refused("[0, 1, 2]", "[0, $.inf, 2]", "'position'", "inf")
        refused("radius: 1", "radius: $-1", "'radius'", "-1")
        refused("radius: 1", "radius: $0", "'radius'", "0")
        refused("[8, 8]", "[$0, 8]", "'resolution'", "0")

    def test_a_scene_without_a_light_is_refused(self):
        self.write("dark.yaml", SCENE.replace("lights: [{type: point, position: [0, 1, 2]}]\n", ""))
        self.assert_refused(BAD_INPUT, ["dark.yaml", "light"], ["render", "dark.yaml"])

    def test_a_bad_mesh_is_refused_at_its_place(self):
        with_mesh = SCENE.replace("{type: sphere, radius: 1}", "{type: mesh, file: shape.obj}")
        self.write("mesh.yaml", with_mesh)
        # The value of 'file' is on line 6: objects: [{shape: {type: mesh, file: shape.obj}, ...
        column = with_mesh.splitlines()[5].index("shape.obj") + 1
        with self.subTest("missing file"):
            words = [f"mesh.yaml:6:{column}: ", "shape.obj", "no such file"]
            self.assert_refused(BAD_INPUT, words, ["render", "mesh.yaml"])
        self.write("shape.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n")
        with self.subTest("the third corner, in column 7, names vertex 4 of 3"):
            words = ["shape.obj:4:7: ", "4", "out of range"]
            self.assert_refused(BAD_INPUT, words, ["render", "mesh.yaml"])


class Usage(Refusals):
    def test_a_command_line_that_cannot_be_parsed_is_wrong_usage(self):
        self.assert_all_refused(USAGE, {
            "no subcommand": ([], "subcommand"),
            "unknown subcommand": (["rendre", "scene.yaml"], "subcommand"),
            "no scene": (["render"], "SCENE"),
            "two scenes": (["render", "scene.yaml", "scene.yaml"], "scene.yaml"),
            "unknown option": (["render", "scene.yaml", "--frobnicate"], "--frobnicate"),
            "option without its value": (["render", "scene.yaml", "--seed"], "--seed"),
        })  # fmt: skip

    def test_a_value_that_an_option_cannot_take_is_wrong_usage(self):
        def render(*options):
            return ["render", "scene.yaml", *options]

        self.assert_all_refused(USAGE, {
            "resolution 0x10": (render("--resolution", "0x10"), "--resolution", "0"),
            "resolution 99999999x2": (render("--resolution", "99999999x2"), "--resolution", "99999999"),
            "each side allowed, the area not": (render("--resolution", "65536x65536"), "--resolution", "pixels"),
            "resolution axb": (render("--resolution", "axb"), "--resolution", "axb"),
            "resolution of one side": (render("--resolution", "10"), "--resolution", "10"),
            "negative resolution": (render("--resolution", "-1x4"), "--resolution", "-1"),
            "resolution beyond 64 bits": (render("--resolution", "18446744073709551617x1"), "--resolution"),
            "passes 0": (render("--passes", "0"), "--passes", "0"),
            "passes 1.5": (render("--passes", "1.5"), "--passes", "1.5"),
            "no passes": (render("--passes", ""), "--passes"),
            "photons 0": (render("--photons", "0"), "--photons", "0"),
            "photons 2^31": (render("--photons", str(2**31)), "--photons", str(2**31)),
            "seed -1": (render("--seed", "-1"), "--seed", "-1"),
            "seed 2^32": (render("--seed", str(2**32)), "--seed", str(2**32)),
            "max depth 256": (render("--max-depth", "256"), "--max-depth", "256"),
            "unknown integrator": (render("--integrator", "pmm"), "--integrator", "did you mean 'ppm'?"),
            "unknown backend": (render("--backend", "cuda"), "--backend", "cuda", "vulkan", "reference"),
            "timeout of no device": (render("--backend", "reference", "--device-timeout", "5"), "--backend reference", "--device-timeout"),
            "set without =": (render("--set", "render.seed"), "--set", "render.seed", "key=value"),
            "set unknown key": (render("--set", "render.fotons=1"), "--set", "'fotons'", "'photons'"),
            "set unknown group": (render("--set", "rendr.seed=1"), "--set", "'rendr.seed'", "'render'"),
            "set without a value": (render("--set", "render.seed="), "--set"),
        })  # fmt: skip

    def test_a_limit_that_no_number_can_exceed_is_wrong_usage(self):
        # NaN compares false with everything: as a limit or threshold it would silently never apply, or always.
        self.assert_all_refused(USAGE, {
            "time nan": (["render", "scene.yaml", "--time", "nan"], "--time"),
            "time 0": (["render", "scene.yaml", "--time", "0"], "--time"),
            "time -1": (["render", "scene.yaml", "--time", "-1"], "--time"),
            "within nan": (["compare", "a.png", "a.png", "--within", "nan"], "--within"),
            "max-rmse nan": (["compare", "a.png", "a.png", "--max-rmse", "nan"], "--max-rmse"),
        })  # fmt: skip

    def test_a_message_is_readable_even_when_the_mistake_is_not(self):
        self.write("scene.yaml", SCENE)
        with self.subTest("a value with a line break is shown on one line"):
            self.assert_refused(DEVICE, ["'a"], ["render", "scene.yaml", "--device", "a\nb"])
        with self.subTest("an option with a line break is shown on one line"):
            self.assert_refused(USAGE, ["--a"], ["render", "scene.yaml", "--a\nb"])
        with self.subTest("the range of --time is not written out to the largest number there is"):
            message = self.run_program("render", "scene.yaml", "--time", "0").stderr
            self.assertLess(len(message), 200, message)


class Outputs(Refusals):
    def test_an_output_that_cannot_be_a_picture_file_is_wrong_usage(self):
        self.assert_all_refused(USAGE, {
            "unknown extension": (["render", "scene.yaml", "-o", "x.tiff"], "x.tiff", "'.tiff'", ".png or .exr"),
            "no extension": (["render", "scene.yaml", "-o", "x"], "x: ", ".png or .exr"),
            "no name": (["render", "scene.yaml", "-o", ""], ".png or .exr"),
        })  # fmt: skip

    def test_an_output_that_cannot_be_written_is_reported_before_the_render(self):
        (self.folder / "folder.png").mkdir()
        (self.folder / "dangling.png").symlink_to("missing/x.png")
        os.mkfifo(self.folder / "pipe.png")

        # A pass takes about a millisecond: a million passes far exceed this test's time limit.
        def render(*outputs):
            return ["render", "scene.yaml", "--passes", "1000000", *(word for path in outputs for word in ("-o", path))]

        self.assert_all_refused(OUTPUT, {
            "the folder is missing": (render("missing/x.png"), "missing/x.png", "folder does not exist"),
            "it is a folder": (render("folder.png"), "folder.png", "it is a folder"),
            "it is a pipe": (render("pipe.png"), "pipe.png", "pipe"),
            "its folder is a file": (render("scene.yaml/x.png"), "scene.yaml/x.png", "Not a directory"),
            "a link into a missing folder": (render("dangling.png"), "dangling.png", "folder does not exist"),
            # The file system of /proc accepts no new files, not even from root.
            "the file system takes no files": (render("/proc/x.png"), "/proc/x.png"),
            "the name is too long": (render("n" * 300 + ".png"), "name is too long"),
            "the second of two": (render("good.png", "missing/x.exr"), "missing/x.exr"),
        }, timeout=20)  # fmt: skip

    def test_a_file_that_outgrows_the_systems_limit_is_reported_and_removed(self):
        # Simulates a full disk: only the first bytes can be written. The reference writes no other files.
        limit = functools.partial(resource.setrlimit, resource.RLIMIT_FSIZE, (200, 200))
        self.write("scene.yaml", SCENE)
        arguments = ["render", "scene.yaml", "--backend", "reference", "--resolution", "64x64", "-o", "x.exr"]
        self.assert_refused(OUTPUT, ["x.exr", "File too large", "ulimit -f"], arguments, preexec_fn=limit)

    def test_text_that_cannot_be_written_is_reported(self):
        self.write("scene.yaml", SCENE)
        self.succeed("render", "scene.yaml", "--quiet", "-o", "scene.png")
        for arguments in (
            ["render", "scene.yaml", "--json", "-o", "scene.png"],
            ["compare", "scene.png", "scene.png"],
            ["doctor"],
        ):
            with self.subTest(arguments[0]), open("/dev/full", "w", encoding="utf-8") as full:
                self.assert_refused(OUTPUT, ["output"], arguments, stdout=full)


class Devices(Refusals):
    def test_a_device_that_is_not_there_is_a_device_error(self):
        self.assert_all_refused(DEVICE, {
            "unknown name": (["render", "scene.yaml", "--device", "abacus"], "'abacus'", "there are 0: "),
            "index out of range": (["render", "scene.yaml", "--device", "99"], "'99'", "there are 0: "),
        })  # fmt: skip

    def test_without_a_driver_the_message_says_what_to_install(self):
        # The loader's old and new variable; if they are set, it searches nowhere else.
        nowhere = {"VK_DRIVER_FILES": "/nonexistent", "VK_ICD_FILENAMES": "/nonexistent"}
        words = ["no Vulkan driver", "mesa-vulkan-drivers", "scripts/install-deps.sh"]
        self.assert_all_refused(DEVICE, {"render": (["render", "scene.yaml"], *words)}, environment=nowhere)
        with self.subTest("doctor"):
            result = self.run_program("doctor", environment=nowhere)
            self.assertEqual((result.returncode, result.stderr), (DEVICE, ""))
            for word in words:
                self.assertIn(word, result.stdout)

    def test_missing_validation_layers_are_reported_when_they_are_asked_for(self):
        self.write("scene.yaml", SCENE)
        nowhere = {"VK_LAYER_PATH": str(self.folder)}
        words = ["VK_LAYER_KHRONOS_validation", "vulkan-validationlayers"]
        self.assert_refused(DEVICE, words, ["render", "scene.yaml", "--validation"], environment=nowhere)


class Shaders(Refusals):
    def copy_shaders(self):
        shutil.copytree(Setup.source / "shaders", self.folder / "shaders")

    def insert_mistake(self, path):
        """Adds a line that glslang cannot parse at the end, where every bracket is closed. Returns its place."""
        file = self.folder / "shaders" / path
        lines = file.read_text().splitlines()
        file.write_text("\n".join([*lines, "int planted = ;", ""]))
        return f"shaders/{path}:{len(lines) + 1}:"

    def test_a_folder_without_shaders_is_wrong_usage(self):
        (self.folder / "empty").mkdir()
        self.assert_all_refused(USAGE, {
            "empty folder": (["render", "scene.yaml", "--shaders", "empty"], "empty", "not a folder of shaders"),
            "missing folder": (["render", "scene.yaml", "--shaders", "none"], "none", "not a folder of shaders"),
            "a file": (["render", "scene.yaml", "--shaders", "scene.yaml"], "not a folder of shaders"),
        })  # fmt: skip

    def test_a_syntax_error_in_a_kernel_names_kernel_file_and_line(self):
        self.copy_shaders()
        place = self.insert_mistake("kernels/gather_radiance.comp")
        words = [place, "'gather_radiance'", "syntax error"]
        self.assert_all_refused(BAD_INPUT, {"kernel": (["render", "scene.yaml", "--shaders", "shaders"], *words)})

    def test_a_syntax_error_in_an_included_file_names_that_file_and_the_kernel(self):
        self.copy_shaders()
        place = self.insert_mistake("bsdf/dielectric.glsl")
        words = [place, "kernel '", "syntax error"]
        self.assert_all_refused(BAD_INPUT, {"library": (["render", "scene.yaml", "--shaders", "shaders"], *words)})

    def test_a_missing_kernel_is_named(self):
        self.copy_shaders()
        (self.folder / "shaders/kernels/trace_shadow.comp").unlink()
        words = ["'trace_shadow'", "shaders/kernels/trace_shadow.comp"]
        self.assert_all_refused(BAD_INPUT, {"kernel": (["render", "scene.yaml", "--shaders", "shaders"], *words)})

    def test_a_picture_with_nan_in_it_is_never_written(self):
        self.copy_shaders()
        resolve = self.folder / "shaders/kernels/resolve_film.comp"
        good = "(filmColor(args.first.at[i]) + filmColor(args.second.at[i])) * args.scale;"
        self.assertIn(good, resolve.read_text())
        # Pixel 9 of 8 x 8 is (1, 1).
        bad = "i == 9 ? vec3(uintBitsToFloat(0x7fc00000u)) : " + good
        resolve.write_text(resolve.read_text().replace(good, bad))
        words = ["1 pixels", "NaN", "(1, 1)"]
        arguments = ["render", "scene.yaml", "--shaders", "shaders", "-o", "x.png", "-o", "x.exr"]
        self.assert_all_refused(OUTPUT, {"NaN": (arguments, *words)})


class Compare(Refusals):
    def test_pictures_that_cannot_be_compared_are_refused(self):
        self.write("scene.yaml", SCENE)
        self.write("text.png", "this is no picture\n")
        for size in ("8x8", "9x8"):
            options = ["--backend", "reference", "--resolution", size, "--quiet", "-o", f"{size}.png"]
            self.succeed("render", "scene.yaml", *options)
        whole = (self.folder / "8x8.png").read_bytes()
        self.write("half.png", whole[: len(whole) // 2])

        self.assert_all_refused(BAD_INPUT, {
            "a text file": (["compare", "8x8.png", "text.png"], "text.png", "neither a PNG nor an EXR"),
            "a missing file": (["compare", "none.png", "8x8.png"], "none.png", "No such file"),
            "a folder": (["compare", ".", "8x8.png"], ".: ", "not a file"),
            "half a file": (["compare", "half.png", "8x8.png"], "half.png"),
        })  # fmt: skip
        self.assert_all_refused(USAGE, {
            "different sizes": (["compare", "8x8.png", "9x8.png"], "8 x 8", "9 x 8"),
            "one picture": (["compare", "8x8.png"], "B is required"),
            "a crop outside": (["compare", "8x8.png", "8x8.png", "--crop", "0,0,9,8"], "crop", "8 x 8"),
        })  # fmt: skip
        difference = ["compare", "8x8.png", "8x8.png", "-o", "missing/d.png"]
        self.assert_all_refused(OUTPUT, {"difference not writable": (difference, "missing/d.png")})
