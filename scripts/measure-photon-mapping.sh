#!/usr/bin/env bash
# Makes the tables of docs/photon-mapping.md: the caustic photons stored with and without the projection map; the shadow
# rays that shadow photons save, and the error that this adds.
#   scripts/measure-photon-mapping.sh [SCENE...]     names in scenes/; by default the three of the document
set -euo pipefail
cd "$(dirname "$0")/.."
hyalite=${HYALITE:-build/release/host/hyalite}
[ -x "$hyalite" ] || { echo "measure-photon-mapping.sh: no program at $hyalite: run scripts/render.sh first" >&2; exit 2; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
scenes=("$@")
[ $# -gt 0 ] || scenes=(cornell-caustics cornell-box glass-teapot)

# run NAME SCENE PASSES OPTION...: renders to NAME.exr and writes the report to NAME.json
run() {
    name=$1
    scene=$2
    passes=$3
    shift 3
    "$hyalite" render "scenes/$scene.yaml" --integrator photonmap --resolution 256x256 --passes "$passes" --json \
        -o "$folder/$name.exr" "$@" > "$folder/$name.json"
}

echo "| scene | caustic photons stored, aimed | not aimed |"
echo "|---|---|---|"
for scene in "${scenes[@]}"; do
    run aimed "$scene" 1
    run astray "$scene" 1 --set render.projection_map=false
    python3 - "$folder" "$scene" <<'PYTHON'
import json, sys
share = []
for name in ("aimed", "astray"):
    counts = json.load(open(f"{sys.argv[1]}/{name}.json"))["counts"]
    emitted = counts["caustic_photons_emitted"]
    share.append(f"{100 * counts['caustic_photons_stored'] / emitted:.2f} %" if emitted else "nothing specular")
print(f"| {sys.argv[2]} | {share[0]} | {share[1]} |")
PYTHON
done

echo
echo "| scene | shadow_photons | shadow rays saved | added relMSE | time relative to no shadow photons |"
echo "|---|---|---|---|---|"
for scene in "${scenes[@]}"; do
    run exact "$scene" 8
    for agreeing in 4 8 16 32; do
        run spared "$scene" 8 --set "render.shadow_photons=$agreeing"
        "$hyalite" compare "$folder/spared.exr" "$folder/exact.exr" --json > "$folder/compare.json"
        python3 - "$folder" "$scene" "$agreeing" <<'PYTHON'
import json, sys
folder, scene, agreeing = sys.argv[1:]
exact, spared, compare = (json.load(open(f"{folder}/{name}.json")) for name in ("exact", "spared", "compare"))
counts = spared["counts"]
share = counts["shadow_rays_saved"] / max(1, counts["shadow_rays_saved"] + counts["shadow_rays"])
time = spared["seconds"]["render"] / exact["seconds"]["render"]
print(f"| {scene} | {agreeing} | {100 * share:.1f} % | {compare['relmse']:.2e} | {time:.2f} |")
PYTHON
    done
done
