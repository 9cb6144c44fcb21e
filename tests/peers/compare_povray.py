#!/usr/bin/env python3
"""Renders one scene by hyalite and by POV-Ray 3.7, alternately; reports which is faster and how similar the pictures are.

  compare_povray.py [--runs N] [--program HYALITE] [--keep FOLDER]

Needs Debian's povray (apt-get install povray). hyalite's time is that of a pass after the first, POV-Ray's is its trace time:
neither includes start-up, reading the scene or writing the picture; one ray per pixel, on all cores. The machine should
be otherwise idle.
"""

import argparse
import json
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
PROGRAM = HERE.parent.parent / "build/release/host/hyalite"
SIZE = (1280, 960)


def by_povray(picture):
    command = ["povray", f"+I{HERE / 'whitted.pov'}", f"+O{picture}", f"+W{SIZE[0]}", f"+H{SIZE[1]}", "+FE",
               "File_Gamma=1.0", "-D", "-A"]
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    found = re.search(r"Trace Time:.*\(([\d.]+) seconds\)", result.stdout)
    if result.returncode != 0 or not found:
        sys.exit(f"compare_povray.py: povray failed:\n{result.stdout}")
    return float(found[1])


def run(program, *arguments):
    result = subprocess.run([program, *arguments], stdout=subprocess.PIPE, text=True, check=False)
    if result.returncode != 0:
        sys.exit(f"compare_povray.py: hyalite ended with exit code {result.returncode}")
    return json.loads(result.stdout)


def by_hyalite(program):
    report = run(program, "bench", HERE / "whitted.yaml", "--stage", "render", "--runs", "3", "--json")
    return report["scenes"][0]["stages"][0]["seconds"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--program", default=PROGRAM, type=pathlib.Path)
    parser.add_argument("--keep", type=pathlib.Path, help="existing folder for both pictures")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = arguments.keep or pathlib.Path(temporary)
        theirs, ours = folder / "povray.exr", folder / "hyalite.exr"
        run(arguments.program, "render", HERE / "whitted.yaml", "-o", ours, "--json")
        pairs = [(by_povray(theirs), by_hyalite(arguments.program)) for _ in range(arguments.runs)]
        compared = run(arguments.program, "compare", theirs, ours, "--json")
    povray, hyalite = (statistics.median(times) for times in zip(*pairs))
    ratio = statistics.median(p / h for p, h in pairs)
    alike = compared["within"]["share"]
    print(f"POV-Ray {povray:.2f} s, hyalite {hyalite:.2f} s: {ratio:.2f} times as fast (medians of {len(pairs)} runs)")
    print(f"{100 * alike:.1f} % of the pixels are alike to 1 %; the shadow of the glass ball is not: POV-Ray's is clear")


if __name__ == "__main__":
    main()
