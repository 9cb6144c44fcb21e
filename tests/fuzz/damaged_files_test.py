"""Every file reader, given damaged files, reads them or reports an error: FUZZERS INPUTS, the folder of the programs and
the number of files for each. The files are the same on every run."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import damage

HERE = pathlib.Path(__file__).resolve().parent
SCENES = HERE.parents[1] / "scenes"
FUZZERS, INPUTS = pathlib.Path(sys.argv[1]), int(sys.argv[2])
MOST = 2560  # [MiB], as scripts/fuzz.sh
# The shipped files that suit a reader, in addition to the seeds
SHIPPED = {"scene": ["*.yaml", "*/*.yaml"], "obj": ["models/*.obj"], "ply": ["models/*.ply"], "stl": ["models/*.stl"],
           "gltf": ["models/*.glb", "models/*.gltf"], "image": [], "checkpoint": [], "photons": []}


class DamagedFiles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        subprocess.run([sys.executable, "-B", HERE / "make_seeds.py", cls.folder / "seeds"], check=True)

    def test_every_reader_answers(self):
        for reader, patterns in SHIPPED.items():
            with self.subTest(reader):
                shipped = [path for pattern in patterns for path in sorted(SCENES.glob(pattern))]
                seeds = [path.read_bytes() for path in sorted((self.folder / "seeds" / reader).iterdir()) + shipped]
                seeds = [seed for seed in seeds if 0 < len(seed) <= damage.LARGEST]
                inputs = self.folder / "inputs" / reader
                inputs.mkdir(parents=True)
                for number, data in enumerate(damage.damaged(seeds, INPUTS, seed=reader)):
                    (inputs / f"{number:06}").write_bytes(data)
                result = subprocess.run([FUZZERS / f"read_{reader}", inputs], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
                *read, peak = result.stdout.decode().splitlines() or [""]
                if result.returncode != 0:
                    last = pathlib.Path(peak)
                    kept = pathlib.Path.cwd() / f"found-{reader}"
                    kept.write_bytes(last.read_bytes() if last.is_file() else b"")
                    self.fail(f"ends with {result.returncode} at {last.name}, kept as {kept}: {result.stderr.decode()[-2000:]}")
                self.assertEqual(len(read), INPUTS)
                self.assertLess(int(peak.split()[1]), MOST)
                print(f"{reader}: {len(read)} inputs, {peak}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
