#!/usr/bin/env bash
# Builds two commits side by side and runs `hyalite bench` of both alternately: shows which is faster, stage by stage.
set -euo pipefail

usage() {
    cat <<'END'
usage: scripts/compare-commits.sh BEFORE AFTER [--turns N] [SCENE...] [bench options]

  BEFORE, AFTER   commits; their builds are kept in build/commits/ and reused
  --turns N       number of measurements of each commit (5); within a turn bench takes its own median
  SCENE, options  passed to `hyalite bench`, e.g. mesh-room --stage camera bounce

Prints for every scene and stage the ratio of BEFORE's core time to AFTER's, the median over the turns: above 1, AFTER
is faster.
END
}

if [[ $# -lt 2 || $1 == -* ]]; then
    usage
    if [[ ${1:-} == --help || ${1:-} == -h ]]; then exit 0; else exit 2; fi
fi
names=("$1" "$2")
shift 2
turns=5
if [[ ${1:-} == --turns ]]; then
    turns=$2
    shift 2
fi

root=$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")
programs=()
for name in "${names[@]}"; do
    commit=$(git -C "$root" rev-parse --verify "$name^{commit}")
    tree=$root/build/commits/${commit:0:12}
    if [[ ! -x $tree/build/release/host/hyalite ]]; then
        mkdir -p "$tree"
        git -C "$root" archive "$commit" | tar -x -C "$tree"
        (cd "$tree" && cmake --preset release -DHYALITE_TESTS=OFF >&2 && cmake --build --preset release --target hyalite >&2)
    fi
    programs+=("$tree/build/release/host/hyalite")
done

results=$(mktemp -d)
trap 'rm -rf "$results"' EXIT
for ((turn = 0; turn < turns; ++turn)); do
    for side in 0 1; do
        "${programs[$side]}" bench --json "$@" >"$results/$turn-$side.json"
    done
done

python3 - "$results" "$turns" "${names[@]}" <<'END'
import json
import pathlib
import statistics
import sys

folder, turns, before, after = pathlib.Path(sys.argv[1]), int(sys.argv[2]), *sys.argv[3:]
times = {}
for turn in range(turns):
    for side in (0, 1):
        report = json.loads((folder / f"{turn}-{side}.json").read_text())
        for scene in report["scenes"]:
            for stage in scene["stages"]:
                if "core_seconds" in stage:
                    times.setdefault((scene["scene"], stage["stage"]), ([], []))[side].append(stage["core_seconds"])
print(f"core time of {before} over that of {after}, medians of {turns} turns")
for (scene, stage), (old, new) in times.items():
    if len(old) == len(new) == turns:
        print(f"{scene:24} {stage:10} {statistics.median(a / b for a, b in zip(old, new)):6.2f}")
END
