#!/usr/bin/env bash
# How the cost of a ray grows with the triangles of a mesh: renders one teapot at levels of about 1 thousand to
# 10 million triangles and prints a table. ns/ray: trace_closest over the camera rays and photons of four passes, the
# median of five runs; seconds: the whole of the first run, with its peak memory.
#   scripts/measure-triangles.sh [LEVEL...]
set -euo pipefail
cd "$(dirname "$0")/.."
hyalite=${HYALITE:-build/release/host/hyalite}
[ -x "$hyalite" ] || { echo "measure-triangles.sh: no program at $hyalite: run scripts/render.sh first" >&2; exit 2; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

echo "| triangles | ns/ray | seconds | peak memory [MB] |"
echo "|---|---|---|---|"
for level in "${@:-4 12 40 125 395}"; do
    for n in $level; do
        cat > "$folder/scene.yaml" <<SCENE
hyalite: 1
camera: {position: [0, 3, 7], look_at: [0, 1.4, 0], fov: 40, resolution: [512, 512]}
render: {integrator: ppm, passes: 4, photons: 200000, max_depth: 8}
materials:
  white: {type: diffuse, albedo: 0.7}
objects:
  - {shape: {type: teapot, level: $n}, material: white}
  - {shape: {type: plane, point: [0, 0, 0], normal: [0, 1, 0]}, material: white}
  - {shape: {type: quad, corner: [-2, 6, -2], edges: [[4, 0, 0], [0, 0, 4]]}, emission: 8}
SCENE
        for run in 1 2 3 4 5; do
            python3 - "$hyalite" "$folder" > "$folder/run$run" <<'PYTHON'
import os, subprocess, sys, time
start = time.time()
program = subprocess.Popen([sys.argv[1], "render", sys.argv[2] + "/scene.yaml", "-o", sys.argv[2] + "/out.png",
                            "--profile", "--quiet"], stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
out = program.stdout.read() + program.stderr.read()
_, status, usage = os.wait4(program.pid, 0)
if status != 0:
    sys.exit(out)
ns = next(line.split()[-1] for line in out.splitlines() if line.startswith("trace_closest"))
print(ns, "%.1f" % (time.time() - start), usage.ru_maxrss // 1024)
PYTHON
        done
        ns=$(cut -d' ' -f1 "$folder"/run? | sort -g | sed -n 3p)
        echo "| $((64 * n * n - 8 * n)) | $ns | $(cut -d' ' -f2 "$folder/run1") | $(cut -d' ' -f3 "$folder/run1") |"
    done
done
