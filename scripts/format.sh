#!/usr/bin/env bash
# Formats the C++ sources and the headers they share with the shaders.
set -euo pipefail

case ${1:-} in
'') mode=(-i) ;;
--check) mode=(--dry-run --Werror) ;;
*)
    echo "usage: scripts/format.sh [--check]    --check: change nothing; fail if a file is not formatted"
    [[ $1 == -h || $1 == --help ]] && exit
    exit 2
    ;;
esac

cd "$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")"
if ! command -v clang-format-19 >/dev/null; then
    echo "format.sh: clang-format-19 is missing: run scripts/install-deps.sh test" >&2
    exit 1
fi
find host tests shaders/shared scenes/experiments \( -name '*.h' -o -name '*.cpp' \) -print0 | xargs -0 clang-format-19 "${mode[@]}"
