#!/usr/bin/env bash
# Builds and runs the tests; first installs missing packages. Succeeds only if every test ran and passed.
set -euo pipefail

usage() {
    cat <<'END'
usage: scripts/test.sh [full|thorough|fast|debug|asan|checked] [ctest options]

  full    every test, with the Vulkan validation layers on, then a short run of scripts/fuzz.sh (the default)
  thorough
          as full, with four times the rays in tests that trace millions of rays at solids
  fast    the tests not labelled slow, without the layers: for quick iteration
  debug   every test of a debug build
  asan    every test of a build with the address and undefined-behaviour sanitizers
  checked every test, with kernels that check their indices (slow)

Installs missing Debian packages (as root or with sudo). A skipped test, or no test at all, is a failure.
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

# ctest succeeds even if tests were skipped or disabled; its report counts them.
counts=$(tr '\n' ' ' <"$report" | grep -o '<testsuite [^>]*>')
if [[ ! $counts =~ disabled=\"0\" || ! $counts =~ skipped=\"0\" ]]; then
    echo "test.sh: some tests were skipped or disabled (listed above): that counts as a failure" >&2
    exit 1
fi

# A fixed number of inputs per reader, the same in every run until a reader changes
if [[ $preset == validation && $# -eq 0 ]]; then
    scripts/fuzz.sh 2000
fi
