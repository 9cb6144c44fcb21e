#!/usr/bin/env bash
# Builds the fuzzers and runs each with the given number of inputs, starting from the seeds of tests/fuzz/make_seeds.py
# and the files of scenes/. Fails at the first crash, undefined behaviour, leak, input that takes more than 10 s or
# 2.5 GiB of memory, and keeps that input.
set -euo pipefail

runs=${1:-20000}
if [[ ! $runs =~ ^[0-9]+$ || $# -gt 2 ]]; then
    echo "usage: scripts/fuzz.sh [inputs for each fuzzer (20000)] [one fuzzer, e.g. gltf]" >&2
    exit 2
fi
cd "$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")"
scripts/install-deps.sh fuzz
cmake --preset fuzz >/dev/null
cmake --build --preset fuzz --target fuzzers

python3 tests/fuzz/make_seeds.py build/fuzz/seeds
found=build/fuzz/found
mkdir -p "$found"
for fuzzer in ${2:-scene obj ply stl gltf image checkpoint photons}; do
    # libFuzzer adds new inputs to the first corpus
    corpus=(build/fuzz/learnt-"$fuzzer" build/fuzz/seeds/"$fuzzer")
    mkdir -p "${corpus[@]}"
    case $fuzzer in
    scene) corpus+=(scenes) ;;
    obj | ply | stl | gltf) corpus+=(scenes/models) ;;
    esac
    log=build/fuzz/"$fuzzer".log
    # A fixed seed makes the run repeatable
    if ! build/fuzz/tests/fuzz/fuzz_"$fuzzer" -runs="$runs" -seed=1 -max_len=16384 -timeout=10 -rss_limit_mb=2560 \
        -detect_leaks=1 -print_final_stats=1 -artifact_prefix="$found/$fuzzer-" "${corpus[@]}" >"$log" 2>&1; then
        tail -n 60 "$log" >&2
        echo "fuzz.sh: $fuzzer failed; the input is in $found, the full log in $log" >&2
        exit 1
    fi
    printf '%-11s %s inputs, %s MiB at most, %s features covered\n' "$fuzzer" \
        "$(sed -n 's/^stat::number_of_executed_units: //p' "$log")" \
        "$(sed -n 's/^stat::peak_rss_mb: *//p' "$log")" \
        "$(sed -n 's/.* ft: \([0-9]*\) .*/\1/p' "$log" | tail -n 1)"
done
