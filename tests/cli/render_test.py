"""`hyalite render` follows its options and reports what it did; doctor, --version and --help print information."""

import os
import pathlib
import pty
import re
import shutil
import struct
import subprocess
import time

from exr import Picture
from program import BAD_INPUT, OUTPUT, SCENE, CliTest, Setup, command_line, default_environment, scene_file

SMALL = ["--resolution", "20x12", "--photons", "2000"]
TWO_PASSES = ["--passes", "2"]


class RenderTest(CliTest):
    def setUp(self):
        super().setUp()
        self.cornell = scene_file("cornell-caustics.yaml")

    def picture(self, *options, scene=None):
        """Channels of the default scene at low resolution, rendered with these additional options."""
        self.succeed("render", scene or self.cornell, *SMALL, *options, "--quiet", "-o", "picture.exr")
        return Picture(self.folder / "picture.exr").channels


class Pictures(RenderTest):
    def test_png_and_exr_are_written_in_one_go_and_show_the_same(self):
        # Radiance in this scene is at most 0.5/pi * 10/4 = 0.4: nothing is clipped by PNG's range of 0 to 1.
        options = ["--resolution", "20x12", "--passes", "1", "--quiet", "-o", "a.png", "-o", "a.exr"]
        self.succeed("render", scene_file("tests/point-light-floor.yaml"), *options)
        self.assertEqual(sorted(self.contents()), ["a.exr", "a.png"])
        png = (self.folder / "a.png").read_bytes()
        self.assertEqual(png[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack_from(">II", png, 16), (20, 12))  # IHDR
        picture = Picture(self.folder / "a.exr")
        self.assertEqual((picture.width, picture.height), (20, 12))
        # 8-bit sRGB is off by at most half a step, 0.5/255. The slope of sRGB's decoding is largest at 1, where it is
        # 2.4/1.055 = 2.275, so in linear radiance the two differ by at most 0.5/255 * 2.275 = 0.0045.
        largest = self.succeed_json("compare", "a.png", "a.exr")["largest_difference"]["value"]
        self.assertLess(largest, 0.0045)

    def test_the_default_output_is_the_scenes_name_as_png_in_the_current_folder(self):
        self.write("scenes/my.room.yaml", SCENE)
        self.succeed("render", "scenes/my.room.yaml", "--quiet")
        self.assertEqual(sorted(self.contents()), ["my.room.png", "scenes", "scenes/my.room.yaml"])

    def test_an_existing_output_is_replaced_whole(self):
        self.write("scene.yaml", SCENE)
        self.succeed("render", "scene.yaml", "--quiet", "-o", "new.exr", "-o", "new.png")
        for ending in ("exr", "png"):
            # Longer than the picture: a file overwritten in place would keep its end.
            junk = b"junk" * 100000
            os.link(self.write(f"old.{ending}", junk), self.folder / f"other-name.{ending}")
            self.succeed("render", "scene.yaml", "--quiet", "-o", f"old.{ending}")
            files = self.contents()
            self.assertEqual(files[f"old.{ending}"], files[f"new.{ending}"])
            self.assertEqual(files[f"other-name.{ending}"], junk, "the file was written in place, not replaced")

    def test_an_output_that_is_a_link_is_written_where_the_link_leads(self):
        self.write("scene.yaml", SCENE)
        self.write("folder/present.png", "old")
        for name in ("present", "absent"):
            with self.subTest(name):
                link = self.folder / f"{name}-link.png"
                link.symlink_to(f"folder/{name}.png")
                self.succeed("render", "scene.yaml", "--quiet", "-o", link.name)
                self.assertTrue(link.is_symlink(), "the link was replaced by a file")
                self.assertEqual((self.folder / f"folder/{name}.png").read_bytes()[1:4], b"PNG")

    def test_a_failing_render_leaves_an_existing_output_untouched(self):
        self.write("scene.yaml", SCENE)
        self.write("bad.yaml", SCENE.replace("radius: 1", "radius: -1"))
        self.write("out.png", "precious")
        shutil.copytree(Setup.source / "shaders", self.folder / "shaders")
        with (self.folder / "shaders/kernels/resolve_film.comp").open("a") as shader:
            shader.write("planted mistake\n")
        # assert_refused checks that no file has changed.
        self.assert_refused(BAD_INPUT, ["radius"], ["render", "bad.yaml", "-o", "out.png"])
        with_mistake = ["render", "scene.yaml", "--shaders", "shaders", "-o", "out.png"]
        self.assert_refused(BAD_INPUT, ["resolve_film"], with_mistake)
        self.assert_refused(OUTPUT, ["none/x.exr"], ["render", "scene.yaml", "-o", "out.png", "-o", "none/x.exr"])


class Settings(RenderTest):
    def test_the_seed_changes_the_picture_and_the_same_seed_gives_the_same_bytes(self):
        pixels = self.picture(*TWO_PASSES, "--seed", "7")
        first = (self.folder / "picture.exr").read_bytes()
        self.picture(*TWO_PASSES, "--seed", "7")
        self.assertEqual((self.folder / "picture.exr").read_bytes(), first)
        # Pixels, not bytes: the seed itself is written into the file.
        self.assertNotEqual(self.picture(*TWO_PASSES, "--seed", "8"), pixels)

    def test_passes_and_samples_are_the_same_setting_and_change_the_picture(self):
        two = self.picture("--passes", "2")
        self.assertNotEqual(self.picture("--passes", "1"), two)
        self.assertEqual(self.picture("--samples", "2"), two)

    def test_set_does_the_same_as_the_option_of_that_name_and_as_the_scene_file(self):
        by_option = self.picture(*TWO_PASSES, "--seed", "7")
        self.assertEqual(self.picture(*TWO_PASSES, "--set", "render.seed=7"), by_option)
        text = pathlib.Path(self.cornell).read_text()
        self.assertIn("seed: 1}", text)
        self.write("cornell.yaml", text.replace("seed: 1}", "seed: 7}"))
        self.assertEqual(self.picture(*TWO_PASSES, scene="cornell.yaml"), by_option)

    def test_integrator_and_depth_may_be_changed_together_in_any_order(self):
        # The scene has whitted and depth 0, which ppm rejects; both are overridden.
        floor = scene_file("tests/point-light-floor.yaml")
        integrator, depth = ["--integrator", "ppm"], ["--max-depth", "4"]
        for options in ([*integrator, *depth], [*depth, *integrator]):
            with self.subTest(options):
                report = self.succeed_json("render", floor, *options, *SMALL, *TWO_PASSES, "-o", "x.png")
                self.assertEqual(report["integrator"], "ppm")

    def test_a_time_limit_ends_the_render_before_its_passes_are_done(self):
        # One pass at this size takes a few hundredths of a second: 100000 would take an hour.
        options = ["--resolution", "64x64", "--photons", "20000", "--passes", "100000", "--time", "1", "-o", "x.png"]
        start = time.monotonic()
        report = self.succeed_json("render", self.cornell, *options)
        self.assertGreaterEqual(report["passes"], 1)
        self.assertLess(report["passes"], 100000)
        # The limit, plus the time of two passes and program start on a busy machine.
        self.assertLess(report["seconds"]["render"], 3)
        self.assertLess(time.monotonic() - start, 20)


class Reports(RenderTest):
    def test_json_is_one_object_with_consistent_numbers(self):
        start = time.monotonic()
        options = [*SMALL, *TWO_PASSES, "--seed", "3", "-o", "a.png", "-o", "b.exr"]
        report = self.succeed_json("render", self.cornell, *options)
        elapsed = time.monotonic() - start
        keys = (
            "version scene integrator backend device seed sampler resolution passes interrupted error_estimate pixels_without_light seconds counts "
            "buffer_bytes search_radius caustic_search_radius warnings outputs"
        )
        self.assertEqual(set(report), set(keys.split()))
        self.assertEqual("hyalite " + report["version"], self.succeed("--version").strip())
        self.assertEqual(report["scene"], self.cornell)
        self.assertEqual((report["integrator"], report["backend"]), ("ppm", "vulkan"))
        self.assertIn(report["device"].split(",")[0], self.succeed("doctor"))
        self.assertEqual((report["seed"], report["resolution"], report["passes"]), (3, [20, 12], 2))
        self.assertEqual(report["sampler"], "sobol")
        self.assertGreater(report["error_estimate"], 0)
        self.assertEqual(report["outputs"], ["a.png", "b.exr"])

        counts, seconds = report["counts"], report["seconds"]
        self.assertEqual(counts["photons_emitted"], 2 * 2000)  # passes x photons
        self.assertGreater(counts["photons_stored"], 0)
        # Every photon has at least the segment from the light, and is stored at most once per segment.
        self.assertGreaterEqual(counts["photon_rays"], counts["photons_emitted"])
        self.assertLessEqual(counts["photons_stored"], counts["photon_rays"])
        # One ray per pixel and pass, and more through glass and mirrors. Some of the pixels see the box.
        self.assertGreaterEqual(counts["camera_rays"], 2 * 20 * 12)
        self.assertGreater(counts["shadow_rays"], 0)
        self.assertGreater(seconds["render"], 0)
        self.assertLessEqual(seconds["setup"] + seconds["render"], seconds["total"])
        self.assertLessEqual(seconds["total"], elapsed)

    def test_the_scenes_settings_are_reported_where_no_option_is_given(self):
        self.write("scene.yaml", SCENE)
        report = self.succeed_json("render", "scene.yaml")
        self.assertEqual((report["seed"], report["resolution"], report["passes"]), (1, [8, 8], 1))
        self.assertIsNone(report["error_estimate"])  # one pass gives no error estimate
        self.assertEqual(report["outputs"], ["scene.png"])

    def test_profile_adds_to_json_every_stage_with_the_threads_that_the_counts_promise(self):
        radii = ["--set", "render.radius=0.05", "--set", "render.caustic_radius=0.02"]  # with caustics some photons would find them
        report = self.succeed_json("render", self.cornell, *SMALL, *TWO_PASSES, *radii, "--profile", "-o", "x.png")
        self.assertEqual((report["search_radius"], report["caustic_search_radius"]), (0.05, 0.02))
        stages, counts = report["stages"], report["counts"]
        threads = {name: stage["threads"] for name, stage in stages.items()}
        self.assertEqual(threads["emit_photons"], counts["photons_emitted"])
        self.assertEqual(threads["emit_caustic_photons"], counts["caustic_photons_emitted"])
        self.assertEqual(threads["trace_closest"], counts["camera_rays"] + counts["photon_rays"])
        # Visible points have a thread each, but light comes to those alone that face it
        self.assertLess(counts["shadow_rays"], threads["trace_shadow"])
        self.assertGreater(counts["shadow_rays"], threads["trace_shadow"] // 4)
        self.assertEqual(threads["sort_photons"], counts["photons_stored"] + counts["caustic_photons_stored"])
        self.assertEqual(threads["resolve_film"], 4 * 20 * 12)  # emitted, direct, caustic and indirect light
        self.assertTrue(all(stage["dispatches"] > 0 for stage in stages.values()), stages)
        self.assertLess(sum(stage["seconds"] for stage in stages.values()), report["seconds"]["total"])

    def test_profile_prints_the_sizes_of_the_buffers(self):
        options = [*SMALL, *TWO_PASSES, "--profile", "-o", "x.png"]
        table = self.succeed("render", self.cornell, *options, "--quiet")
        report = self.succeed_json("render", self.cornell, *options)
        sizes = report["buffer_bytes"]
        listed = dict(re.findall(r"^(\S.*?) +([\d.]+)$", table[table.index("buffer ") :].partition("all buffers")[0], re.MULTILINE))
        # Buffers of at least one per cent, the largest first, in mebibytes to one digit
        total = sum(sizes.values())
        expected = {name: f"{size / 2**20:.1f}" for name, size in sizes.items() if 100 * size >= total}
        self.assertEqual(listed, expected)
        self.assertEqual(list(listed), sorted(listed, key=lambda name: -sizes[name]))
        self.assertRegex(table, rf"(?m)^all buffers +{total / 2**20:.1f} ")

    def test_profile_prints_a_table_with_every_kernel_that_ran(self):
        # Together these run every kernel except those of the self-test, the tests and the live page, and clear buffers
        # in between.
        kernels = {path.stem for path in (Setup.source / "shaders/kernels").glob("*.comp")}
        expected = kernels - {"self_test", "nearest_photons", "show_surface"} | {"clear", "copy", "set"}
        found = set()
        materials = scene_file("tests/all-materials.yaml")
        for scene, integrator, *settings in (
            (self.cornell, "whitted"),
            (materials, "ppm"),
            (self.cornell, "path"),
            (self.cornell, "photonmap", "shadow_photons=4", "view=photons", "caustic_photons=2000"),
            (self.cornell, "photonmap", "precomputed_irradiance=false"),
        ):
            options = ["--integrator", integrator, "--max-depth", "5", "--profile", "--quiet", "-o", "x.png"]
            for setting in settings:
                options += ["--set", "render." + setting]
            table = self.succeed("render", scene, *SMALL, *TWO_PASSES, *options)
            rows = re.findall(r"^(\w+) +([\d.]+) +([\d.]+) % +(\d+) +([\d.]+)$", table, re.MULTILINE)
            self.assertIn("all stages", table)
            found |= {row[0] for row in rows}
            # Shares are rounded to 0.1 %, so the sum is off by at most 0.05 per row.
            self.assertAlmostEqual(sum(float(row[2]) for row in rows), 100, delta=0.05 * len(rows))
        self.assertEqual(found, expected)

    def test_a_plain_render_says_which_files_it_wrote_and_a_quiet_one_nothing(self):
        self.write("scene.yaml", SCENE)
        said = self.succeed("render", "scene.yaml", "-o", "a.png", "-o", "b.exr").splitlines()
        self.assertEqual(len(said), 2)
        for line, name in zip(said, ("a.png", "b.exr")):
            self.assertTrue(line.startswith(f"{self.folder.resolve() / name}: 8 x 8, "), line)
        self.assertEqual(self.succeed("render", "scene.yaml", "--quiet"), "")


class Backends(RenderTest):
    def test_device_and_reference_agree_far_closer_than_two_seeds_do(self):
        size = ["--resolution", "48x48", "--passes", "4", "--photons", "20000", "--quiet"]
        for sampler in ("sobol", "independent"):
            with self.subTest(sampler):
                self.check_backends([*size, "--sampler", sampler])

    def check_backends(self, size):
        for name, options in {
            "device": ["--seed", "1"],
            "reference": ["--seed", "1", "--backend", "reference"],
            "other-seed": ["--seed", "2", "--backend", "reference"],
        }.items():
            self.succeed("render", self.cornell, *size, *options, "-o", f"{name}.exr")
        same = self.succeed_json("compare", "device.exr", "reference.exr")
        other = self.succeed_json("compare", "other-seed.exr", "reference.exr")
        # Both sides draw the same random numbers and so follow the same paths, except for the few where single
        # precision decides differently: an edge, a roulette, a photon on the rim of the search disc. At least 99 % of
        # the pixels must agree within 1 %.
        self.assertGreaterEqual(same["within"]["share"], 0.99, same)
        # A pixel whose path diverged is as far off as one of another seed. With at most 1 % of such pixels the error is
        # at most a hundredth of that between seeds.
        self.assertLessEqual(same["relmse"], 0.01 * other["relmse"], (same, other))


class Progress(RenderTest):
    # Return to the start of the line and clear it.
    WIPE = "\r\x1b[K"

    def stderr_on_a_terminal(self, *options):
        """The render's stderr as written to a terminal; its stdout is discarded."""
        self.write("scene.yaml", SCENE)
        ours, theirs = pty.openpty()
        command = command_line(["render", "scene.yaml", "--passes", "100000", "--time", "0.7", *options])
        with subprocess.Popen(
            command, cwd=self.folder, env=default_environment(), stdout=subprocess.DEVNULL, stderr=theirs
        ) as process:
            os.close(theirs)
            text = b""
            while chunk := self.read_terminal(ours):
                text += chunk
        os.close(ours)
        self.assertEqual(process.returncode, 0, text)
        return text.decode()

    @staticmethod
    def read_terminal(descriptor):
        try:
            return os.read(descriptor, 65536)
        except OSError:  # Linux reports this once the other end is closed
            return b""

    def test_a_bar_appears_on_a_terminal_and_is_wiped(self):
        text = self.stderr_on_a_terminal()
        self.assertRegex(text, r"\[#* *\] +\d+ %  \d+/100000 passes  (\d+:\d\d left|starting)")
        self.assertTrue(text.endswith(self.WIPE), text[-200:])
        # Each bar replaces the previous one on the same line.
        self.assertNotIn("\n", text)
        self.assertEqual(text.count("["), 2 * text.count("passes") + 1, "[ of a bar and its wipe, and of the last wipe")

    def test_quiet_and_json_show_no_bar_on_a_terminal(self):
        for option in ("--quiet", "--json"):
            with self.subTest(option):
                self.assertEqual(self.stderr_on_a_terminal(option), "")

    def test_no_bar_goes_into_a_pipe(self):
        self.write("scene.yaml", SCENE)
        result = self.run_program("render", "scene.yaml", "--passes", "100000", "--time", "0.7")
        self.assertEqual((result.returncode, result.stderr), (0, ""))


class Information(CliTest):
    def test_doctor_names_the_driver_and_passes(self):
        report = self.succeed_json("doctor")
        self.assertIs(report["usable"], True)
        self.assertEqual([check for check in report["checks"] if check["needed"] and not check["passed"]], [])
        names = {check["name"] for check in report["checks"]}
        self.assertEqual(names, {"device", "shaders", "self-test", "validation", "editor"})
        (chosen,) = [device for device in report["devices"] if device["chosen"]]
        self.assertEqual(chosen["missing"], [])
        text = self.succeed("doctor")
        self.assertIn(f"* {chosen['index']}: {chosen['name']}, {chosen['driver']}", text)
        self.assertIn("hyalite can render here", text)

    def test_version_is_the_projects(self):
        project = (Setup.source / "CMakeLists.txt").read_text()
        version = re.search(r"project\(hyalite VERSION ([\d.]+)", project)[1]
        self.assertEqual(self.succeed("--version"), f"hyalite {version}\n")

    def test_help_names_every_command_and_option(self):
        text = self.succeed("--help")
        for command in ("render", "compare", "doctor"):
            self.assertIn(command, text)
            self.assertIn("Usage: hyalite", self.succeed(command, "--help"))
        text = self.succeed("render", "--help")
        options = "output integrator backend device resolution passes samples photons max-depth time seed sampler target-error shaders set"
        for option in [*options.split(), "profile", "json", "quiet"]:
            self.assertIn(f"--{option} ", text)
