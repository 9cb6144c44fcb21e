#!/usr/bin/env bash
# The slow checks of the sources: a clang++ build with the same warnings, then clang-tidy on every file.
set -euo pipefail

if [[ $# -gt 0 ]]; then
    echo "usage: scripts/lint.sh    builds with clang++ in build/lint and runs clang-tidy; installs both tools if missing"
    [[ $1 == -h || $1 == --help ]] && exit
    exit 2
fi

cd "$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")"
scripts/install-deps.sh lint
cmake --preset lint >/dev/null
cmake --build --preset lint
run-clang-tidy -quiet -p build/lint "$PWD/(host|tests|scenes)/"
