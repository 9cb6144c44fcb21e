"""Invalid radiance values: counted, reported by pixel and pass, and kept out of every file."""

import json
import math
import shutil

from exr import Picture
from program import SCENE, CliTest, Setup

# Values that a faulty shader may write: the kind, a value, and its pixel in the 8 x 8 picture.
FAULTS = {
    "not a number": ("uintBitsToFloat(0x7fc00000u)", 19),
    "infinite": ("uintBitsToFloat(0x7f800000u)", 20),
    "negative": ("-1.0", 21),
    "too bright for the film": ("1.0e30", 63),
}


class Numbers(CliTest):
    def test_what_is_no_radiance_is_reported_and_reaches_no_file(self):
        self.write("scene.yaml", SCENE)
        shutil.copytree(Setup.source / "shaders", self.folder / "shaders")
        shader = self.folder / "shaders/kernels/shade_surface.comp"
        good = shader.read_text()
        mark = "args.emitted.at[path.pixel] ="
        self.assertEqual(good.count(mark), 1)
        planted = "".join(f"if (path.pixel == {pixel}u && args.pass == 1u) {{ emitted.y = {value}; }}\n    "
                          for value, pixel in FAULTS.values())
        shader.write_text(good.replace(mark, planted + mark))
        result = self.run_program("render", "scene.yaml", "--shaders", "shaders", "--passes", "3", "--json",
                                  "--checkpoint", "kept", "-o", "a.exr")
        self.assertEqual(result.returncode, 0, result.stderr)
        merged = self.run_program("merge", "kept", "--quiet", "-o", "b.exr")
        warnings = json.loads(result.stdout)["warnings"]
        self.assertEqual(len(warnings), len(FAULTS))
        for kind, (_, pixel) in FAULTS.items():
            where = f"{pixel % 8},{pixel // 8}"
            said = f"1 value of layer 'emitted' was {kind} and left out, the first at pixel {where} of pass 1"
            look = f"hyalite inspect scene.yaml --pixel {where} --pass 1"
            self.assertIn(f"{said} (look at it with: {look})", warnings)
            self.assertIn(said, result.stderr)
            self.assertIn(said, merged.stderr)  # the checkpoint keeps the counts
        self.assertTrue(all(math.isfinite(v) and v >= 0 for v in Picture(self.folder / "a.exr").values()))
        shown = self.run_program(*look.split()[1:], "--shaders", "shaders")
        self.assertEqual(shown.returncode, 0, shown.stderr)
