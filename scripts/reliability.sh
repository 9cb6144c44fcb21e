#!/usr/bin/env bash
# Measures the figures of docs/reliability.md: fuzzed inputs, survived kills, sanitizers, memory of a long run.
set -euo pipefail

usage() {
    cat <<'END'
usage: scripts/reliability.sh [quick|full] [PART...]

  quick   a few minutes per part (the default)
  full    as documented: 20 000 inputs per reader, 100 kills, a render of one hour; takes hours
  PART    fuzz, kills, leak, threads, memory, indices (all parts)

  fuzz      damaged files for every reader (scripts/fuzz.sh)
  kills     renders killed at random moments, each continuing from the previous one's checkpoint
  leak      whether the memory of a long render grows
  threads   the loaders and the reference under ThreadSanitizer
  memory    the tests under AddressSanitizer and UndefinedBehaviorSanitizer; quick: those not labelled slow
  indices   the tests with kernels that check their indices; quick: those not labelled slow
END
}

kind=quick
case ${1:-} in
quick | full) kind=$1 && shift ;;
--help | -h) usage && exit ;;
esac
parts=("$@")
if ((${#parts[@]} == 0)); then
    parts=(fuzz kills leak threads memory indices)
fi
cd "$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")"
program=build/release/host/hyalite
declare -A inputs=([quick]=1000 [full]=20000) kills=([quick]=10 [full]=100) seconds=([quick]=120 [full]=3600)
choice=()
if [[ $kind == quick ]]; then choice=(-LE slow); fi

for part in "${parts[@]}"; do
    echo "== $part"
    case $part in
    fuzz) scripts/fuzz.sh "${inputs[$kind]}" ;;
    kills) python3 tests/cli/kills.py "$program" "${kills[$kind]}" ;;
    leak) python3 tests/cli/leak.py "$program" scenes/cornell-caustics.yaml "${seconds[$kind]}" ;;
    threads)
        cmake --preset tsan >/dev/null
        targets=(scene_test hierarchy_test reference_world_test reference_photons_test reference_ppm_test reference_whitted_test)
        cmake --build --preset tsan --target "${targets[@]}" >/dev/null
        for target in "${targets[@]}"; do
            said=$("$(find build/tsan/tests -type f -name "$target")" | tail -n 2 | head -n 1)
            echo "$target: $said"
        done
        ;;
    memory) scripts/test.sh asan "${choice[@]}" ;;
    indices) scripts/test.sh checked "${choice[@]}" ;;
    *) usage >&2 && exit 2 ;;
    esac
done
