#!/usr/bin/env python3
"""Compares the speed of two commits: builds both beside the tree, runs `hyalite bench` of each by turns, and prints for
every stage how much of the first one's time the second takes.

  scripts/bench-compare.py OLD NEW [--rounds 5] [-- options of hyalite bench, e.g. mesh-room --stage camera]

Ratios are medians over the rounds of time by the clock, and of the time that all cores together computed: the latter
holds on a busy machine too. Below 1 the second commit is faster. Builds are kept in build/bench-compare.
"""

import argparse
import json
import pathlib
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def run(*command, **options):
    return subprocess.run(command, check=True, cwd=ROOT, **options)


def build(commit):
    """The program of a commit, built in a work tree of its own."""
    name = run("git", "rev-parse", "--verify", "--short=12", f"{commit}^{{commit}}", stdout=subprocess.PIPE, text=True)
    tree = ROOT / "build/bench-compare" / name.stdout.strip()
    if not tree.exists():
        run("git", "worktree", "prune")
        run("git", "worktree", "add", "--detach", "--quiet", str(tree), name.stdout.strip())
    quiet = {"stdout": subprocess.DEVNULL}
    run("cmake", "-S", str(tree), "--preset", "release", "-DHYALITE_TESTS=OFF", **quiet)
    run("cmake", "--build", str(tree / "build/release"), "--target", "hyalite", **quiet)
    return tree / "build/release/host/hyalite"


def measure(program, options):
    """(scene, stage) to (seconds by the clock, seconds of all cores)."""
    report = json.loads(run(program, "bench", "--json", *options, stdout=subprocess.PIPE, text=True).stdout)
    return {
        (scene["scene"], stage["stage"]): (stage["seconds"], stage["core_seconds"])
        for scene in report["scenes"]
        for stage in scene["stages"]
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("--rounds", type=int, default=5)
    words = sys.argv[1:]
    split = words.index("--") if "--" in words else len(words)
    arguments, options = parser.parse_args(words[:split]), words[split + 1 :]
    if arguments.rounds < 1:
        parser.error("--rounds must be at least 1")
    programs = [build(commit) for commit in (arguments.old, arguments.new)]
    rounds = []
    for number in range(arguments.rounds):
        order = (0, 1) if number % 2 == 0 else (1, 0)  # so that neither always runs on the warmer machine
        times = {which: measure(programs[which], options) for which in order}
        rounds.append((times[0], times[1]))
    print(f"{'scene':24} {'stage':10} {'old [ms]':>10} {'new [ms]':>10} {'clock':>7} {'cores':>7}")
    for key in rounds[0][0]:
        pairs = [(old[key], new[key]) for old, new in rounds if key in new]
        if not pairs:
            continue
        old, new = (1e3 * statistics.median(pair[side][0] for pair in pairs) for side in (0, 1))
        clock, cores = (statistics.median(new[kind] / old[kind] for old, new in pairs) for kind in (0, 1))
        print(f"{key[0]:24} {key[1]:10} {old:10.2f} {new:10.2f} {clock:7.3f} {cores:7.3f}")


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as error:
        sys.exit(f"bench-compare.py: {' '.join(map(str, error.cmd))} failed with exit code {error.returncode}")
