#!/usr/bin/env python3
"""Measures how fast renders converge: error over passes and seconds, on logarithmic axes, with fitted slopes.

  measure-convergence.py error SCENE -o FOLDER     several ways to render, against a converged picture
  measure-convergence.py samplers SCENE -o FOLDER  Sobol points against independent numbers, and their gain
  measure-convergence.py bias SCENE -o FOLDER      the bias of ppm against the rate predicted by theory

Each writes figures.json, figures.csv, plot.svg and plot.png to FOLDER; docs/convergence.md describes the measurements.
Needs Debian's python3-matplotlib (which depends on python3-numpy).
"""

import argparse
import csv
import json
import math
import pathlib
import subprocess
import sys

from plotting import numpy, pyplot

SOURCE = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(SOURCE / "tests/cli"))
from exr import Picture  # noqa: E402  (the tests' reader)


class Renderer:
    """Runs the program on one scene; writes pictures to a folder."""

    def __init__(self, arguments):
        self.program = pathlib.Path(arguments.program).resolve()
        if not self.program.is_file():
            sys.exit(f"measure-convergence.py: no program at {self.program}: run scripts/render.sh first")
        self.scene = arguments.scene
        self.common = ["--resolution", arguments.resolution, *arguments.option]
        self.folder = pathlib.Path(arguments.output)
        self.folder.mkdir(parents=True, exist_ok=True)

    def run(self, *arguments):
        result = subprocess.run([self.program, *map(str, arguments)], stdout=subprocess.PIPE, text=True, check=False)
        if result.returncode != 0:
            sys.exit(f"measure-convergence.py: hyalite ended with exit code {result.returncode}")
        return json.loads(result.stdout)

    def render(self, name, passes, seed, options=()):
        """The report and the picture's file."""
        path = self.folder / f"{name}.exr"
        arguments = [*self.common, *options, "--passes", passes, "--seed", seed, "--json", "-o", path]
        report = self.run("render", self.scene, *arguments)
        return report, path

    def error(self, path, reference):
        """Root of relMSE."""
        return math.sqrt(self.run("compare", path, reference, "--json")["relmse"])


def read_picture(path, layer=""):
    """An array of height x width x 3, or None if the file has no such layer."""
    picture = Picture(path, layer)
    if picture.layer + "R" not in picture.channels:
        return None
    return numpy.stack([numpy.array(picture.channels[picture.layer + name]) for name in "RGB"], axis=-1)


def slope(xs, ys):
    """Slope of the least-squares line through the logarithms; None for fewer than two points."""
    points = [(math.log(x), math.log(y)) for x, y in zip(xs, ys) if x > 0 and y > 0]
    if len(points) < 2:
        return None
    x, y = numpy.array(points).T
    return float(numpy.polyfit(x, y, 1)[0])


def write_figures(folder, about, rows):
    (folder / "figures.json").write_text(json.dumps({**about, "rows": rows}, indent=2) + "\n")
    with (folder / "figures.csv").open("w", newline="") as file:
        writer = csv.DictWriter(file, fieldnames=list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)


def draw(folder, panels):
    """Plots panels of (label of x, label of y, lines), with lines of (name, xs, ys, style)."""
    figure, axes = pyplot.subplots(1, len(panels), figsize=(5.5 * len(panels), 4.5), squeeze=False)
    for axis, (x_label, y_label, lines) in zip(axes[0], panels):
        for name, xs, ys, style in lines:
            points = [(x, y) for x, y in zip(xs, ys) if y > 0]  # a bias below its noise is 0 and has no logarithm
            axis.loglog(*zip(*points) if points else ([], []), style, label=name, markersize=4)
        axis.set_xlabel(x_label)
        axis.set_ylabel(y_label)
        axis.grid(True, which="both", alpha=0.3)
        axis.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(folder / "plot.svg", metadata={"Date": None})
    figure.savefig(folder / "plot.png", dpi=100, metadata={"Software": None})
    print(folder / "plot.svg")


def passes_of(arguments, way):
    return arguments.passes.get(way, arguments.passes[""])


def measure(renderer, arguments, ways, reference):
    """Rows of way, passes, seconds, true error, estimated error: root mean squares over the seeds."""
    rows = []
    for way, options in ways.items():
        for passes in passes_of(arguments, way):
            found = []
            for seed in range(1, arguments.seeds + 1):
                report, path = renderer.render("picture", passes, seed, options)
                found.append((report["seconds"]["render"], renderer.error(path, reference), report["error_estimate"]))
                path.unlink()
            seconds, errors, estimates = zip(*found)
            row = {
                "way": way,
                "passes": passes,
                "seconds": sum(seconds) / len(seconds),
                "error": math.sqrt(sum(e * e for e in errors) / len(errors)),
                "estimate": None if None in estimates else math.sqrt(sum(e * e for e in estimates) / len(estimates)),
            }
            rows.append(row)
            print(f"{way:24} {passes:6} passes {row['seconds']:9.2f} s  error {row['error']:.5f}  "
                  f"estimated {row['estimate'] or math.nan:.5f}", flush=True)
    return rows


def lines_of(rows, key, ways):
    lines, slopes = [], {}
    for way in ways:
        chosen = [row for row in rows if row["way"] == way]
        xs, ys = [row[key] for row in chosen], [row["error"] for row in chosen]
        slopes[way] = slope(xs, ys)
        name = way if slopes[way] is None else f"{way}: slope {slopes[way]:.2f}"
        lines.append((name, xs, ys, "o-"))
    return lines, slopes


def converged(renderer, arguments, options):
    """The picture to compare with: the given one, or one rendered with a seed that no measured picture uses."""
    if arguments.reference:
        return pathlib.Path(arguments.reference)
    print(f"the converged picture: {' '.join(options) or 'the scene as it is'}, {arguments.reference_passes} passes",
          flush=True)
    return renderer.render("reference", arguments.reference_passes, 1000003, [*options, "--layers"])[1]


def measure_error(arguments):
    renderer = Renderer(arguments)
    ways = {way: way_options(way) for way in arguments.ways.split(",")}
    reference = converged(renderer, arguments, way_options(arguments.reference_way))
    rows = measure(renderer, arguments, ways, reference)
    by_passes, slopes_passes = lines_of(rows, "passes", ways)
    by_time, slopes_time = lines_of(rows, "seconds", ways)
    about = describe(arguments, slopes_against_passes=slopes_passes, slopes_against_seconds=slopes_time)
    write_figures(renderer.folder, about, rows)
    label = "error (root of relMSE)"
    draw(renderer.folder, [("passes", label, by_passes), ("seconds", label, by_time)])


def measure_samplers(arguments):
    renderer = Renderer(arguments)
    base = way_options(arguments.ways.split(",")[0])
    ways = {"sobol": [*base, "--sampler", "sobol"], "independent": [*base, "--sampler", "independent"]}
    reference = converged(renderer, arguments, way_options(arguments.reference_way))
    rows = measure(renderer, arguments, ways, reference)
    error = {(row["way"], row["passes"]): row["error"] for row in rows}
    both = [passes for passes in passes_of(arguments, "") if ("independent", passes) in error]
    # The error of independent passes falls with the square root of their number: this many more would be needed
    gain = {passes: (error["independent", passes] / error["sobol", passes]) ** 2 for passes in both}
    lines, slopes = lines_of(rows, "passes", ways)
    write_figures(renderer.folder, describe(arguments, slopes_against_passes=slopes, gain=gain), rows)
    for passes, times in gain.items():
        print(f"{passes:6} passes with Sobol points are worth {times:.2f} times as many independent ones")
    draw(renderer.folder, [("passes", "error (root of relMSE)", lines),
                           ("passes", "independent passes worth one", [("gain", list(gain), list(gain.values()), "o-")])])


def measure_bias(arguments):
    """Averages both pictures over blocks of pixels, and ppm's also over many seeds, so that noise is far below bias."""
    renderer = Renderer(arguments)
    reference_path = converged(renderer, arguments, way_options(arguments.reference_way))
    reference = blocks(read_picture(reference_path), arguments.block)
    # Noise of the reference: the pixels of a path-traced picture are independent; its file has their standard errors
    error = read_picture(reference_path, "error")
    reference_variance = 0.0 if error is None else blocks(error**2, arguments.block) / arguments.block**2
    counts = passes_of(arguments, "ppm")
    rows = []
    for passes in counts:
        pictures = []
        for seed in range(1, arguments.seeds + 1):
            _, path = renderer.render("picture", passes, seed, way_options("ppm"))
            pictures.append(blocks(read_picture(path), arguments.block))
            path.unlink()
        difference = numpy.mean(pictures, axis=0) - reference
        # The mean of n pictures has 1/n of their variance; subtract it from the squared difference
        variance = reference_variance + numpy.var(pictures, axis=0, ddof=1) / len(pictures)
        # Relative to the squared radiance, like relMSE: otherwise blocks at the rims of lights would dominate
        square, noise = (float(numpy.mean(value / (reference**2 + 0.01))) for value in (difference**2, variance))
        rows.append({"passes": passes, "bias": math.sqrt(max(0.0, square - noise)), "noise": math.sqrt(noise),
                     "mean_difference": float(numpy.mean(difference)), "mean_radiance": float(numpy.mean(reference))})
        print(f"{passes:6} passes: bias {rows[-1]['bias']:.6f}, noise of the mean {rows[-1]['noise']:.6f}", flush=True)
    biases = [row["bias"] for row in rows]
    rate = slope(counts, biases)
    # The mean over passes of the squared radius; the bias of a pass is proportional to it [Knaus11]
    predicted = [mean_squared_radius(passes, arguments.alpha) for passes in counts]
    ratios = [math.log(b / p) for b, p in zip(biases, predicted) if b > 0]
    scale = math.exp(sum(ratios) / len(ratios)) if ratios else 1.0
    write_figures(renderer.folder, describe(arguments, slope=rate, rate_in_the_limit=arguments.alpha - 1,
                                            slope_of_mean_squared_radius=slope(counts, predicted)), rows)
    draw(renderer.folder, [("passes", "bias, relative, root mean square over blocks", [
        ("measured" if rate is None else f"measured: slope {rate:.2f}", counts, biases, "o-"),
        ("noise left in it", counts, [row["noise"] for row in rows], "x:"),
        (f"mean of r²: N^{arguments.alpha - 1:.2f} in the limit", counts, [scale * p for p in predicted], "--"),
    ])])


def mean_squared_radius(passes, alpha):
    """Mean of r² over the passes, in units of the first: r²(i + 1) = r²(i) (i + alpha) / (i + 1)."""
    square, total = 1.0, 0.0
    for i in range(1, passes + 1):
        total += square
        square *= (i + alpha) / (i + 1)
    return total / passes


def blocks(picture, side):
    """Means over squares of side x side pixels; drops incomplete squares at the edges."""
    height, width = picture.shape[0] // side * side, picture.shape[1] // side * side
    squares = picture[:height, :width].reshape(height // side, side, width // side, side, 3)
    return squares.mean(axis=(1, 3))


def way_options(way):
    """`ppm`, `path+independent`, `path+reference`: an integrator, then a sampler or a backend."""
    integrator, *rest = way.split("+")
    options = ["--integrator", integrator]
    for word in rest:
        options += ["--backend", word] if word in ("vulkan", "reference") else ["--sampler", word]
    return options


def describe(arguments, **more):
    kept = {key: value for key, value in vars(arguments).items() if key not in ("run", "output", "program", "passes")}
    return {**kept, **more}


def passes_argument(text):
    """Parses '1,2,4' for all ways, or 'ppm=1,2,4;path=16,64' with separate lists."""
    lists = {}
    for part in text.split(";"):
        way, _, numbers = part.rpartition("=")
        lists[way] = [int(number) for number in numbers.split(",")]
        if min(lists[way]) < 1:
            raise argparse.ArgumentTypeError("passes are at least 1")
    lists.setdefault("", next(iter(lists.values())))
    return lists


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    for name, run, ways, passes in (("error", measure_error, "ppm,photonmap,path", "4,8,16,32,64,128,256"),
                                    ("samplers", measure_samplers, "path", "4,8,16,32,64,128,256"),
                                    ("bias", measure_bias, "ppm", "1,2,4,8,16,32,64")):
        command = commands.add_parser(name)
        command.set_defaults(run=run)
        command.add_argument("scene")
        command.add_argument("-o", "--output", required=True, help="folder for figures and plot")
        command.add_argument("--program", default=SOURCE / "build/release/host/hyalite")
        command.add_argument("--ways", default=ways, help="integrators, each with +sampler or +backend")
        command.add_argument("--passes", type=passes_argument, default=passes_argument(passes),
                             help="1,2,4 for all ways, or 'ppm=1,2,4;path=16,64'")
        command.add_argument("--seeds", type=int, default=4 if name == "bias" else 1, help="pictures to average over")
        command.add_argument("--resolution", default="128x128")
        command.add_argument("--reference", help="converged picture, .exr; without it, one is rendered")
        command.add_argument("--reference-way", default="path")
        command.add_argument("--reference-passes", type=int, default=4096)
        command.add_argument("--option", action="append", default=[],
                             help="option for every render, e.g. --option=--photons=1000")
        if name == "bias":
            command.add_argument("--block", type=int, default=16, help="side of the blocks of pixels")
            command.add_argument("--alpha", type=float, default=2 / 3, help="render.alpha of the scene")
    arguments = parser.parse_args()
    if arguments.command == "bias" and arguments.seeds < 2:
        parser.error("the bias needs two seeds at least: their difference is the noise that is taken off")
    return arguments


if __name__ == "__main__":
    chosen = parse_arguments()
    chosen.run(chosen)
