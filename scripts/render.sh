#!/usr/bin/env bash
# Renders a scene, installing and building first what is not there yet.
set -euo pipefail

usage() {
    cat <<'END'
usage: scripts/render.sh [SCENE] [hyalite render options]

Renders SCENE (default: scenes/cornell-caustics.yaml) to its name with .png in the current folder, or to -o FILE, and
says where the picture is. SCENE comes before the options; build/release/host/hyalite render --help lists them.
The first call installs missing Debian packages (as root or with sudo) and builds; later ones start at once.
Ends with the exit code of hyalite: 0 done, 2 usage, 3 bad scene, 4 device or driver, 5 output not written.
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

# Standard output stays hyalite's own, for --json.
{
    "$root/scripts/install-deps.sh" render
    # A folder that test.sh configured, tests and all, will do as well.
    if [[ ! -f $build/build.ninja ]]; then (cd "$root" && cmake --preset release -DHYALITE_TESTS=OFF >/dev/null); fi
    ninja -C "$build" hyalite | { grep -Ev '^ninja: (no work to do|Entering directory)' || true; }
} >&2

exec "$build/host/hyalite" render "$scene" "$@"
