#!/usr/bin/env bash
# Audits random scenes: no integrator may return more light than the lights send into a closed room, nor light into a
# sealed one; or (--agree) ppm and path must show the same. Fails if a scene fails; build/audit then has it, as small as
# it can be made.
set -euo pipefail

usage() {
    cat <<'END2'
usage: scripts/audit.sh [--agree] [--device] [scenes (10000)] [number of the first (0)]

  --agree   compare ppm with path instead (500 scenes)
  --device  ask the device instead of the double-precision reference

A correct program fails with a probability of 1e-3, whatever the number of scenes. The same numbers are always the same
scenes. 10 000 scenes take about 20 minutes of CPU time on the reference, several times as long on a software device.
END2
}

kind=energy
backend=reference
while [[ ${1:-} == --* ]]; do
    case $1 in
    --agree) kind=agree ;;
    --device) backend=vulkan ;;
    *) usage >&2 && exit 2 ;;
    esac
    shift
done
scenes=${1:-$([[ $kind == agree ]] && echo 500 || echo 10000)}
first=${2:-0}
if [[ ! $scenes =~ ^[0-9]+$ || ! $first =~ ^[0-9]+$ || $# -gt 2 ]]; then
    usage >&2
    exit 2
fi
cd "$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")"
scripts/install-deps.sh test
cmake --preset release -DHYALITE_TESTS=ON >/dev/null
cmake --build --preset release --target audit_scenes
build/release/tests/transport/audit_scenes "$kind" "$backend" "$first" "$scenes" build/audit
