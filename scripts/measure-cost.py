#!/usr/bin/env python3
"""Measures how render time grows with photons, passes, pixels and triangles: a table and a plot on logarithmic axes.

  measure-cost.py -o FOLDER [--runs N] [--against passes pixels photons triangles]

Seconds are the time of the passes or, for triangles, of tracing camera rays at a mesh of that size. The slope is that
of a line fitted to the logarithms: 1 is linear cost, 0 constant cost; for cost logarithmic in n it falls towards 0.
Writes figures.csv and plot.svg to FOLDER. Needs Debian's python3-matplotlib.
"""

import argparse
import csv
import json
import math
import pathlib
import statistics
import subprocess
import sys
import tempfile

from plotting import numpy, pyplot

SOURCE = pathlib.Path(__file__).resolve().parent.parent
SCENE = SOURCE / "scenes/cornell-caustics.yaml"

# An uneven ground under a point light.
GROUND = """hyalite: 1
camera: {position: [0, 1.6, 2.6], look_at: [0, 0, 0], fov: 40, resolution: [512, 512]}
render: {integrator: whitted, max_depth: 0, passes: 4}
materials: {ground: {type: diffuse, albedo: 0.7}}
lights: [{type: point, position: [1, 3, 1], intensity: [30, 30, 30]}]
objects: [{shape: {type: mesh, file: ground.ply}, material: ground}]
"""


def run(program, *arguments):
    result = subprocess.run([program, *map(str, arguments)], stdout=subprocess.PIPE, text=True, check=False)
    if result.returncode != 0:
        sys.exit(f"measure-cost.py: hyalite ended with exit code {result.returncode}")
    return json.loads(result.stdout)


def write_ground(path, triangles):
    """Writes a square grid of about `triangles` triangles; returns their number."""
    side = max(1, round(math.sqrt(triangles / 2)))
    x, z = numpy.meshgrid(numpy.linspace(-1, 1, side + 1), numpy.linspace(-1, 1, side + 1), indexing="ij")
    y = 0.05 * numpy.sin(9 * x) * numpy.cos(7 * z) + 0.01 * numpy.sin(60 * x + 3 * z)
    number = numpy.arange((side + 1) ** 2).reshape(side + 1, side + 1)
    a, b, c, d = number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]
    corners = numpy.concatenate([numpy.stack(t, -1).reshape(-1, 3) for t in ((a, d, c), (a, c, b))])
    faces = numpy.empty(len(corners), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    faces["count"], faces["corners"] = 3, corners
    header = ("ply\nformat binary_little_endian 1.0\n"
              f"element vertex {number.size}\nproperty float x\nproperty float y\nproperty float z\n"
              f"element face {len(corners)}\nproperty list uchar int vertex_indices\nend_header\n")
    path.write_bytes(header.encode() + numpy.stack([x, y, z], -1).astype("<f4").tobytes() + faces.tobytes())
    return len(corners)


class Costs:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def render(self, *options):
        report = run(self.program, "render", SCENE, *options, "-o", self.folder / "picture.exr", "--json")
        return report["seconds"]["render"]

    def passes(self):
        return [(n, lambda n=n: self.render("--resolution", "256x256", "--passes", n)) for n in (2, 4, 8, 16, 32)]

    def pixels(self):
        fixed = ["--passes", 4, "--photons", 2000, "--set", "render.caustic_photons=2000"]
        return [(n * n, lambda n=n: self.render("--resolution", f"{n}x{n}", *fixed)) for n in (128, 256, 512, 1024)]

    def photons(self):
        # Almost no pixels and no caustic photons: the cost of tracing and sorting photons
        fixed = ["--resolution", "16x16", "--passes", 4, "--set", "render.caustic_photons=0"]
        return [(n, lambda n=n: self.render("--photons", n, *fixed)) for n in (50000, 100000, 200000, 400000, 800000)]

    def triangles(self):
        found = []
        for wanted in (1000, 10000, 100000, 1000000):
            scene = self.folder / f"ground-{wanted}" / "scene.yaml"
            scene.parent.mkdir()
            count = write_ground(scene.parent / "ground.ply", wanted)
            scene.write_text(GROUND)
            found.append((count, lambda scene=scene: self.camera_rays(scene)))
        return found

    def camera_rays(self, scene):
        report = run(self.program, "bench", scene, "--stage", "camera", "--runs", 3, "--json")
        return report["scenes"][0]["stages"][0]["seconds"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", "--output", required=True, type=pathlib.Path, help="folder for figures and plot")
    parser.add_argument("--program", default=SOURCE / "build/release/host/hyalite")
    parser.add_argument("--runs", type=int, default=3, help="number of runs; the median counts")
    kinds = ["passes", "pixels", "photons", "triangles"]
    parser.add_argument("--against", nargs="+", default=kinds, choices=kinds)
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    rows, lines = [], []
    with tempfile.TemporaryDirectory() as temporary:
        costs = Costs(arguments.program, pathlib.Path(temporary))
        for kind in arguments.against:
            sizes = getattr(costs, kind)()
            for _, measured in sizes:
                measured()  # uncounted: compiles the kernels
            times = [[measured() for _, measured in sizes] for _ in range(arguments.runs)]  # alternately
            seconds = [statistics.median(column) for column in zip(*times)]
            counts = [count for count, _ in sizes]
            slope = float(numpy.polyfit(numpy.log(counts), numpy.log(seconds), 1)[0])
            lines.append((f"{kind}: slope {slope:.2f}", counts, seconds))
            rows += [{"against": kind, "count": n, "seconds": f"{s:.4f}"} for n, s in zip(counts, seconds)]
            print(f"{kind:10} " + "  ".join(f"{n}: {s:.3f} s" for n, s in zip(counts, seconds)) + f"  slope {slope:.2f}",
                  flush=True)
    with (arguments.output / "figures.csv").open("w", newline="") as file:
        writer = csv.DictWriter(file, fieldnames=list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
    figure, axes = pyplot.subplots(1, len(lines), figsize=(3.4 * len(lines), 3.2), squeeze=False)
    for axis, (label, counts, seconds) in zip(axes[0], lines):
        axis.loglog(counts, seconds, "o-", markersize=4)
        axis.set_xlabel(label)
        axis.grid(True, which="both", alpha=0.3)
    axes[0][0].set_ylabel("seconds")
    figure.tight_layout()
    figure.savefig(arguments.output / "plot.svg", metadata={"Date": None})


if __name__ == "__main__":
    main()
