"""Checkpoints: no work is lost, however a render ends, and passes rendered anywhere sum to the same bits."""

import json
import shutil
import signal
import subprocess
import time

from kills import kill_renders
from program import BAD_INPUT, OUTPUT, SCENE, TIMEOUT, USAGE, CliTest, Setup, command_line, default_environment, scene_file

INTERRUPTED = 6

# Every integrator, with features that vary between passes: shrinking radii, lenses, photons, ray trees.
SUBJECTS = {
    "ppm": ["cornell-caustics.yaml", "--photons", "2000", "--set", "render.caustic_photons=2000"],
    "path": ["cornell-box.yaml"],
    "photonmap": ["cornell-caustics.yaml", "--photons", "2000", "--set", "render.caustic_photons=2000"],
    "whitted": ["reflections.yaml"],
}


def options(integrator):
    scene, *rest = SUBJECTS[integrator]
    return [scene_file(scene), "--integrator", integrator, "--resolution", "16x12", *rest, "--quiet"]


class CheckpointTest(CliTest):
    def render(self, *arguments):
        self.succeed("render", *arguments)

    def bytes_of(self, name):
        return (self.folder / name).read_bytes()


class Parts(CheckpointTest):
    def test_a_render_in_several_sittings_has_the_bytes_of_one_in_a_single_sitting(self):
        for integrator, sittings in {"ppm": "247", "path": "27", "photonmap": "27", "whitted": "27"}.items():
            with self.subTest(integrator):
                self.render(*options(integrator), "--passes", "7", "--layers", "-o", "whole.exr")
                kept = ["--checkpoint", f"{integrator}.checkpoint", "--resume"]
                for passes in sittings:
                    self.render(*options(integrator), "--passes", passes, *kept, "--layers", "-o", "resumed.exr")
                self.assertTrue(self.bytes_of("whole.exr") == self.bytes_of("resumed.exr"), "the bytes differ")

    def test_parts_in_any_order_merge_to_the_bytes_of_one_render(self):
        self.render(*options("ppm"), "--passes", "9", "--layers", "-o", "whole.exr", "-o", "whole.png")
        parts = []
        for first, end in ((4, 5), (0, 4), (5, 9)):
            parts.append(f"{first}.checkpoint")
            self.render(*options("ppm"), "--passes", f"{first}:{end}", "--checkpoint", parts[-1])
        self.succeed("merge", *parts, "--layers", "--quiet", "-o", "merged.exr", "-o", "merged.png")
        self.assertTrue(self.bytes_of("whole.exr") == self.bytes_of("merged.exr"), "the bytes differ")
        self.assertTrue(self.bytes_of("whole.png") == self.bytes_of("merged.png"), "the bytes differ")

    def test_parts_of_parts_merge_and_a_render_goes_on_from_them_with_what_is_missing(self):
        common = options("ppm")
        self.render(*common, "--passes", "8", "-o", "whole.exr")
        self.render(*common, "--passes", "0:2", "--checkpoint", "a")
        self.render(*common, "--passes", "5:6", "--checkpoint", "b")
        self.succeed("merge", "b", "a", "--quiet", "--checkpoint", "ab")
        report = json.loads(self.succeed("render", *[o for o in common if o != "--quiet"], "--passes", "8",
                                         "--checkpoint", "ab", "--resume", "--json", "-o", "resumed.exr"))
        self.assertEqual((report["resumed_from"], report["passes"]), (3, 8))
        self.assertTrue(self.bytes_of("whole.exr") == self.bytes_of("resumed.exr"), "the bytes differ")

    def test_overlapping_and_foreign_parts_are_refused(self):
        common = options("ppm")
        self.render(*common, "--passes", "0:2", "--checkpoint", "a")
        self.render(*common, "--passes", "1:3", "--checkpoint", "b")
        self.render(*common, "--passes", "2:3", "--seed", "9", "--checkpoint", "seed")
        self.render(*common, "--passes", "2:3", "--set", "camera.fov=50", "--checkpoint", "camera")
        shaders = shutil.copytree(Setup.source / "shaders", self.folder / "shaders")
        with open(shaders / "lib/thread.glsl", "a", encoding="utf-8") as file:
            file.write("// another text\n")
        self.render(*common, "--passes", "2:3", "--shaders", "shaders", "--checkpoint", "shaders-part")
        for part, words in {"b": ["passes 1:2 occur twice"], "a": ["passes 0:2 occur twice"],
                            "seed": ["different render", "render.seed is 9 there and 1 here"],
                            "camera": ["different render", "camera.fov is 50 there and 39.3 here"],
                            "shaders-part": ["different render", "the shaders' hash"]}.items():
            with self.subTest(part):
                self.assert_refused(BAD_INPUT, words, ["merge", "a", part, "-o", "a.exr"])

    def test_ranges_that_are_none_are_refused(self):
        self.write("scene.yaml", SCENE)
        for passes in ("3:3", "4:1", ":4", "2:", "-1:4", "0:4294967296"):
            self.assert_refused(USAGE, ["invalid range of passes"], ["render", "scene.yaml", f"--passes={passes}"])


class Files(CheckpointTest):
    def setUp(self):
        super().setUp()
        self.write("scene.yaml", SCENE)
        self.render("scene.yaml", "--quiet", "--checkpoint", "kept")

    def test_a_checkpoint_is_written_over_by_nobody_but_who_goes_on_from_it(self):
        kept = ["--checkpoint", "kept"]
        self.assert_refused(USAGE, ["kept: the checkpoint already exists", "--resume"],
                            ["render", "scene.yaml", *kept])
        self.assert_refused(USAGE, ["kept: the checkpoint already exists"], ["merge", "kept", *kept])
        self.assert_refused(USAGE, ["--resume needs a checkpoint"], ["render", "scene.yaml", "--resume"])
        self.assert_refused(USAGE, ["--checkpoint"], ["render", "scene.yaml", "--backend", "reference", *kept])
        self.assert_refused(USAGE, ["nothing to write"], ["merge", "kept"])
        self.assert_refused(OUTPUT, ["no/kept"], ["render", "scene.yaml", "--checkpoint", "no/kept"])

    def test_a_checkpoint_of_another_render_is_refused(self):
        self.assert_refused(BAD_INPUT, ["different render", "render.photons is 100 there and 200 here"],
                            ["render", "scene.yaml", "--photons", "200", "--checkpoint", "kept", "--resume"])

    def test_a_damaged_checkpoint_is_refused(self):
        whole = self.bytes_of("kept")
        damaged = {
            "empty": b"",
            "short": whole[:100],
            "cut off": whole[:-50],
            "longer": whole + bytes(8),
            "one bit": whole[:-100] + bytes([whole[-100] ^ 1]) + whole[-99:],
            "of another version": b"hyachkp9" + whole[8:],
            "a scene": SCENE.encode(),
        }
        for name, content in damaged.items():
            with self.subTest(name):
                self.write("kept", content)
                self.assert_refused(BAD_INPUT, ["kept"], ["merge", "kept", "-o", "a.exr"])
                self.assert_refused(BAD_INPUT, ["kept"],
                                    ["render", "scene.yaml", "--checkpoint", "kept", "--resume"])


class Signals(CheckpointTest):
    def start(self, *arguments):
        return subprocess.Popen(
            command_line(["render", *arguments]), cwd=self.folder, env=default_environment(),
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def wait_for(self, condition, process):
        deadline = time.monotonic() + TIMEOUT
        while not condition():
            self.assertIsNone(process.poll(), "the program has ended by itself")
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.02)

    def test_a_signal_ends_a_render_with_the_picture_so_far_and_nothing_lost(self):
        self.write("scene.yaml", SCENE)
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number):
                kept = ["--checkpoint", f"kept-{number}", "--checkpoint-every", "0"]
                process = self.start("scene.yaml", "--passes", "100000000", "--json", *kept, "-o", "a.exr")
                self.wait_for((self.folder / f"kept-{number}").exists, process)
                process.send_signal(number)
                out, err = process.communicate(timeout=TIMEOUT)
                self.assertEqual(process.returncode, INTERRUPTED, err)
                report = json.loads(out)
                self.assertIs(report["interrupted"], True)
                self.assertIn(signal.Signals(number).name, err)
                self.assertIn(f"after {report['passes']} pass", err)
                passes = ["--passes", str(report["passes"]), "--quiet"]
                self.render("scene.yaml", *passes, "-o", "b.exr")
                self.render("scene.yaml", *passes, *kept, "--resume", "-o", "c.exr")
                self.assertTrue(self.bytes_of("a.exr") == self.bytes_of("b.exr"), "the bytes differ")
                self.assertTrue(self.bytes_of("a.exr") == self.bytes_of("c.exr"), "the bytes differ")

    def test_where_the_checkpoint_can_no_longer_be_written_the_picture_is_and_the_render_says_so(self):
        self.write("scene.yaml", SCENE)
        (self.folder / "gone").mkdir()
        kept = ["--checkpoint", "gone/kept", "--checkpoint-every", "0"]
        process = self.start("scene.yaml", "--passes", "100000000", "--json", *kept, "-o", "a.exr")
        self.wait_for((self.folder / "gone/kept").exists, process)
        (self.folder / "gone").rename(self.folder / "elsewhere")
        time.sleep(0.2)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=TIMEOUT)
        self.assertEqual(process.returncode, OUTPUT, err)
        self.assertIn("gone/kept: cannot write the file", err)
        self.assertIs(json.loads(out)["interrupted"], True)
        self.assertTrue((self.folder / "a.exr").exists())
        # The earlier files are still intact
        self.succeed("merge", "elsewhere/kept", "--quiet", "-o", "b.exr")

    def test_the_reference_stops_too(self):
        self.write("scene.yaml", SCENE)
        process = self.start("scene.yaml", "--passes", "100000000", "--backend", "reference", "-o", "a.exr")
        time.sleep(1)
        process.send_signal(signal.SIGTERM)
        _, err = process.communicate(timeout=TIMEOUT)
        self.assertEqual(process.returncode, INTERRUPTED, err)
        self.assertTrue((self.folder / "a.exr").exists())

    def test_a_second_signal_ends_the_program_at_once(self):
        # A pass that takes minutes: a thousand gather rays for each of 250 000 pixels
        process = self.start(scene_file("cornell-box.yaml"), "--integrator", "photonmap", "--photons", "1000",
                             "--set", "render.gather_rays=1000", "--resolution", "500x500", "-o", "a.png")
        time.sleep(3)
        process.send_signal(signal.SIGINT)
        time.sleep(1)
        self.assertIsNone(process.poll(), "the first signal lets the pass end")
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=TIMEOUT)
        self.assertEqual(process.returncode, -signal.SIGINT)
        self.assertEqual(self.contents(), {})


class Kills(CliTest):
    def test_a_render_killed_at_any_moment_leaves_whole_files_and_goes_on(self):
        kills, _, _ = kill_renders(str(Setup.program), 4, environment=default_environment())
        self.assertEqual(kills, 4)
