#!/usr/bin/env bash
# Renders a scene; first installs missing packages and builds.
set -euo pipefail

usage() {
    cat <<'END'
usage: scripts/render.sh [SCENE] [hyalite render options]

Renders SCENE (default: scenes/cornell-caustics.yaml) to a .png file of its name in the current folder, or to -o FILE,
and prints the picture's path. SCENE comes before the options; build/release/host/hyalite render --help lists them.
The first call installs missing Debian packages (as root or with sudo) and builds; later calls start at once.
Exits with the code of hyalite: 0 done, 2 wrong usage, 3 bad scene, 4 device or driver, 5 output not written.
END
}

if [[ ${1:-} == -h || ${1:-} == --help ]]; then usage && exit; fi

root=$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")
build=$root/build/release

scene=$root/scenes/cornell-caustics.yaml
if [[ $# -gt 0 && $1 != -* ]]; then
    scene=$1
    shift
fi

# Only hyalite writes to standard output, for --json.
{
    "$root/scripts/install-deps.sh" render
    # A folder that test.sh configured with tests works too.
    if [[ ! -f $build/build.ninja ]]; then (cd "$root" && cmake --preset release -DHYALITE_TESTS=OFF >/dev/null); fi
    ninja -C "$build" hyalite | { grep -Ev '^ninja: (no work to do|Entering directory)' || true; }
} >&2

exec "$build/host/hyalite" render "$scene" "$@"
