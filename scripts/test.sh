#!/usr/bin/env bash
# Builds and runs the tests, installing first what is missing. Succeeds only when every test ran and passed.
set -euo pipefail

usage() {
    cat <<'END'
usage: scripts/test.sh [full|thorough|fast|debug|asan|checked] [ctest options]

  full    every test, with the Vulkan validation layers on, then scripts/fuzz.sh for a while (the default)
  thorough
          the same with four times the rays where tests throw millions of them at solids
  fast    the tests not labelled slow, without the layers: for the inner loop
  debug   every test of a debug build
  asan    every test of a build with the address and undefined-behaviour sanitizers
  checked every test, with kernels that check their indices (slow)

Missing Debian packages are installed (as root or with sudo). A skipped test, or none at all, is a failure.
END
}

kind=full
if [[ $# -gt 0 && $1 != -* ]] || [[ ${1:-} == --help ]]; then
    kind=$1
    shift
fi
choice=()
case $kind in
full) preset=validation ;;
thorough) preset=validation && export HYALITE_THOROUGH=1 ;;
fast) preset=release choice=(-LE slow) ;;
debug | asan | checked) preset=$kind ;;
--help) usage && exit ;;
*) usage >&2 && exit 2 ;;
esac

cd "$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")"
scripts/install-deps.sh test
cmake --preset "$preset" -DHYALITE_TESTS=ON >/dev/null
cmake --build --preset "$preset"

report=$(mktemp)
trap 'rm -f "$report"' EXIT
ctest --preset "$preset" "${choice[@]}" --parallel "$(nproc)" --no-tests=error --output-junit "$report" "$@"

# ctest succeeds when tests were skipped or disabled; its report counts them.
counts=$(tr '\n' ' ' <"$report" | grep -o '<testsuite [^>]*>')
if [[ ! $counts =~ disabled=\"0\" || ! $counts =~ skipped=\"0\" ]]; then
    echo "test.sh: some tests were skipped or disabled (listed above): that counts as a failure" >&2
    exit 1
fi

# libFuzzer: so many inputs for each reader, the same every time until a reader changes
if [[ $preset == validation && $# -eq 0 ]]; then
    scripts/fuzz.sh 2000
fi
