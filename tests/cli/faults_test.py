"""Failures around a render: a full disk, a folder that disappears, damaged caches, a lost device, no memory."""

import os
import resource
import signal
import subprocess
import time

from program import OUTPUT, SCENE, TIMEOUT, CliTest, command_line, default_environment

# Enough address space for driver and compiler, but not for the 10 GB of 4096 x 4096 pixels [bytes]
TOO_LITTLE = 4 << 30


class Faults(CliTest):
    def setUp(self):
        super().setUp()
        self.write("scene.yaml", SCENE)

    def render(self, cache, output, **options):
        return self.run_program("render", "scene.yaml", "--quiet", "-o", output, environment={"XDG_CACHE_HOME": str(cache)},
                                **options)

    def test_a_disk_that_is_full_leaves_the_old_picture_and_no_half_of_the_new(self):
        # Simulated by a limit on file size: 4 KiB is less than 64 x 64 pixels of noise
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))

        self.write("scene.yaml", SCENE.replace("resolution: [8, 8]", "resolution: [64, 64]"))
        self.write("out.exr", "the old one")
        before = self.contents()
        # Uses the reference: the driver maps files into memory, and is killed if the disk has no room for them
        result = self.run_program("render", "scene.yaml", "--quiet", "-o", "out.exr", "--backend", "reference", preexec_fn=limit)
        self.assertEqual(result.returncode, OUTPUT, result.stderr)
        self.assertIn("larger than the system allows", result.stderr)
        self.assertEqual(self.contents(), before)

    def test_a_folder_that_goes_away_during_a_render_is_an_error_that_names_it(self):
        (self.folder / "pictures").mkdir()
        process = subprocess.Popen(
            command_line(["render", "scene.yaml", "--passes", "1000000", "-o", "pictures/out.exr", "--checkpoint", "kept",
                          "--checkpoint-every", "0"]),
            cwd=self.folder, env=default_environment(), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.kill)
        end = time.monotonic() + 60
        while not (self.folder / "kept").exists() and time.monotonic() < end:
            time.sleep(0.05)
        (self.folder / "pictures").rmdir()
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=TIMEOUT)
        self.assertEqual(process.returncode, OUTPUT, said)
        self.assertIn("pictures/out.exr", said)
        self.assertIn("the folder does not exist", said)
        # The work is not lost: the checkpoint has it
        self.succeed("merge", "kept", "-o", "out.exr", "--quiet")

    def test_two_renders_at_once_fill_one_cache_and_make_the_same_bytes(self):
        cache = self.folder / "cache"
        both = [subprocess.Popen(command_line(["render", "scene.yaml", "--quiet", "-o", f"{i}.exr"]), cwd=self.folder,
                                 env={**default_environment(), "XDG_CACHE_HOME": str(cache)}, stderr=subprocess.PIPE, text=True)
                for i in (1, 2)]
        for process in both:
            _, said = process.communicate(timeout=TIMEOUT)
            self.assertEqual((process.returncode, said), (0, ""))
        self.assertEqual((self.folder / "1.exr").read_bytes(), (self.folder / "2.exr").read_bytes())

    def test_a_damaged_cache_costs_time_and_no_picture(self):
        cache = self.folder / "cache"
        self.assertEqual(self.render(cache, "first.exr").returncode, 0)
        damaged = [path for path in cache.rglob("*") if path.is_file()]
        self.assertGreater(len(damaged), 10)
        for number, path in enumerate(damaged):
            content = path.read_bytes()
            middle = len(content) // 2
            # Truncated, overwritten in the middle, and emptied, in turn
            path.write_bytes([content[:middle], content[:middle] + b"damaged!" + content[middle + 8:], b""][number % 3])
        result = self.render(cache, "second.exr")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual((self.folder / "first.exr").read_bytes(), (self.folder / "second.exr").read_bytes())

    def test_the_bits_do_not_depend_on_when_the_driver_looks_up_its_width(self):
        # Kernels are created while others are compiled to machine code; many overlap only with cold caches. When bits
        # depended on it, two of eight such renders differed
        self.assertEqual(self.render(self.folder / "cache", "right.exr").returncode, 0)
        slow = {"LD_PRELOAD": os.environ["HYALITE_TEST_LAYERS"] + "/libslow_environment.so", "LP_NATIVE_VECTOR_WIDTH": "128"}
        for i in range(3):
            cache = {"XDG_CACHE_HOME": str(self.folder / f"cold-{i}")}
            result = self.run_program("render", "scene.yaml", "--quiet", "-o", "slow.exr", environment={**slow, **cache})
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            self.assertEqual((self.folder / "slow.exr").read_bytes(), (self.folder / "right.exr").read_bytes())

    def test_a_device_that_is_lost_ends_the_render_and_the_checkpoint_has_the_passes(self):
        layer = {"VK_ADD_LAYER_PATH": os.environ["HYALITE_TEST_LAYERS"], "VK_INSTANCE_LAYERS": "VK_LAYER_HYALITE_lost_device"}
        options = ("scene.yaml", "--passes", "400", "--checkpoint", "kept", "--checkpoint-every", "0", "--quiet")
        lost = 0
        for submissions in (0, 40, 150):
            result = self.run_program("render", *options, "--resume", "-o", "lost.exr",
                                      environment={**layer, "HYALITE_LOSE_AT": str(submissions)})
            self.assertEqual(result.returncode, 4, result.stderr)
            self.assertRegex(result.stderr, "the device is lost")
            self.assertFalse((self.folder / "lost.exr").exists())
            lost += (self.folder / "kept").exists()
        self.assertGreater(lost, 0)
        # What was kept goes on to the same bytes
        self.succeed("render", *options, "--resume", "-o", "resumed.exr")
        self.succeed("render", "scene.yaml", "--passes", "400", "--quiet", "-o", "whole.exr")
        self.assertEqual((self.folder / "resumed.exr").read_bytes(), (self.folder / "whole.exr").read_bytes())


class NoMemory(CliTest):
    """Not under AddressSanitizer, which reserves terabytes of address space at startup."""

    def test_without_memory_the_program_says_so_and_writes_nothing(self):
        self.write("scene.yaml", SCENE)
        result = self.run_program(
            "render", "scene.yaml", "--resolution", "4096x4096", "-o", "out.exr",
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (TOO_LITTLE, TOO_LITTLE)))
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertRegex(result.stderr, "memory")
        self.assertEqual(sorted(os.listdir(self.folder)), ["scene.yaml"])
