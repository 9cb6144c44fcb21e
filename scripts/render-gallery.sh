#!/usr/bin/env bash
# Renders the pictures of the README's gallery into docs/gallery, each in less than a minute on two cores.
#   scripts/render-gallery.sh [NAME...]     all pictures, or those named: csg, glass-teapot, ...
set -euo pipefail
cd "$(dirname "$0")/.."
hyalite=${HYALITE:-build/release/host/hyalite}
[ -x "$hyalite" ] || { echo "render-gallery.sh: no program at $hyalite: run scripts/render.sh first" >&2; exit 2; }
mkdir -p docs/gallery

# picture NAME SCENE OPTION...: renders the scene unless other names were asked for
picture() {
    name=$1
    scene=$2
    shift 2
    case " ${wanted:-$name} " in
    *" $name "*) "$hyalite" render "scenes/$scene.yaml" -o "docs/gallery/$name.png" "$@" ;;
    esac
}

wanted=$*
picture reflections-0 reflections --max-depth 0
picture reflections-1 reflections --max-depth 1
picture reflections-5 reflections --max-depth 5
picture glass-and-mirror glass-and-mirror
picture globe globe
picture quadrics quadrics
picture csg csg
picture csg-cube csg-cube
picture glass-teapot glass-teapot
picture instances instances
picture metals metals --resolution 352x352
picture cornell-global cornell-box --set render.gather_rays=0 --passes 8 --resolution 384x384
picture cornell-gather cornell-box --resolution 384x384
picture glass-ball glass-ball --resolution 384x384
picture caustic-ring caustic-ring --resolution 384x384
picture room-through-gap room-through-gap --resolution 344x344
picture teapot-caustic teapot-caustic --resolution 440x330
