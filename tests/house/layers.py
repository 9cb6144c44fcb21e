"""The one-way dependencies of the folders under host/, read from their #include lines."""

import posixpath
import re

RULE = (
    "base <- image <- scene <- geometry <- {gpu, reference} <- {kinds, scene/checks} <- {scene/load, describe} <- render <- {parity, bench} <- live <- cli; "
    "Vulkan only under host/gpu; host/scene is model <- import <- yaml, load stands above kinds, and checks above reference; "
    "host/render is upload <- wavefront <- film <- photons <- integrators <- debug, then the renderer; "
    "host/live is messages <- {page, worker} <- supervisor <- server; "
    "of shaders/ the reference takes only shared/{random,limits,language}.h"
)

RANK = {
    "base": 0,
    "image": 1,
    "scene": 2,
    "geometry": 3,
    "gpu": 4,
    "reference": 4,
    "kinds": 5,
    "scene/checks": 5,
    "scene/load": 6,
    "describe": 6,
    "render": 7,
    "parity": 8,
    "bench": 8,
    "live": 9,
    "cli": 10,
}
MAIN = 11  # host/main.cpp
# Subfolders are ranked in the same way; files directly in a folder rank above its subfolders.
ROOMS = {
    "scene": {"model": 0, "import": 1, "yaml": 2},
    "live": {"messages": 0, "page": 1, "worker": 1, "supervisor": 2, "server": 3},
    "render": {"upload": 0, "wavefront": 1, "film": 2, "photons": 3, "integrators": 4, "debug": 5},
}
ABOVE = 100
REFERENCE_MAY_TAKE = {f"shaders/shared/{name}.h" for name in ("random", "limits", "language")}
INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)')


def folder_of(path):
    """The innermost ranked folder under host/ that contains the file."""
    parts = path.split("/")
    inner = "/".join(parts[1:3])
    if len(parts) > 3 and inner in RANK:
        return inner
    return parts[1] if len(parts) > 2 else None


def room_of(path):
    parts = path.split("/")
    return parts[2] if len(parts) > 3 else None


def includes(tree, path):
    """(line, name, the repository's file or None) of every #include in the file."""
    for number, line in tree.lines(path):
        match = INCLUDE.match(line)
        if not match:
            continue
        name = match[1] or match[2]
        places = [posixpath.dirname(path), "host", ""] if match[1] else ["host", ""]
        candidates = [posixpath.normpath(posixpath.join(place, name)) for place in places]
        yield number, name, next((candidate for candidate in candidates if candidate in tree.path_set), None)


def is_vulkan(name):
    return name.startswith(("vulkan/", "vk_video/")) or name in ("vulkan_raii.hpp", "vulkan.h", "vulkan.hpp")


def reaches_vulkan(tree, path, seen):
    """True if including this file also includes Vulkan's headers."""
    if path in seen:
        return False
    seen.add(path)
    return any(
        is_vulkan(name) or (target is not None and reaches_vulkan(tree, target, seen))
        for _, name, target in includes(tree, path)
    )


def violations_of(tree, path):
    here = folder_of(path)
    if here is not None and here not in RANK:
        yield f"{path}: host/{here} has no place in the order"
        return
    for number, name, target in includes(tree, path):
        where = f"{path}:{number}: #include of {name}"
        if here != "gpu" and (is_vulkan(name) or (target and reaches_vulkan(tree, target, set()))):
            yield f"{where}: Vulkan outside host/gpu"
        if target is None or target == path:
            continue
        if here == "reference" and target.startswith("shaders/") and target not in REFERENCE_MAY_TAKE:
            yield f"{where}: the reference must not take this from shaders/"
        if target.startswith("host/"):
            there = folder_of(target)
            if here != there and RANK.get(there, MAIN) >= RANK.get(here, MAIN):
                yield f"{where}: {here} stands before or beside {there}"
            rooms = ROOMS.get(here)
            room, other = room_of(path), room_of(target)
            if rooms and here == there and room != other and rooms.get(other, ABOVE) >= rooms.get(room, ABOVE):
                yield f"{where}: {here}/{room or ''} stands before or beside {here}/{other or ''}"


def check(tree):
    tree.path_set = set(tree.paths)
    return [found for path in tree.under("host/", ".h", ".cpp") for found in violations_of(tree, path)]


CLEAN = {
    "host/main.cpp": '#include "cli/command.h"\n',
    "host/cli/command.h": '#include "render/ppm.h"\n#include "base/error.h"\n',
    "host/render/ppm.h": '#include "gpu/context.h"\n#include "reference/ppm.h"\n#include "kinds/lights/kinds.h"\n',
    "host/render/integrators/whitted/whitted.h": '#include "render/film/film.h"\n',
    "host/render/film/film.h": "",
    "host/render/photons/map.h": "",
    "host/gpu/context.h": '#include "../base/error.h"\n#include <vector>\n',
    "host/gpu/device.h": "#include <vulkan/vulkan_raii.hpp>\n",
    "host/reference/ppm.h": '#include "geometry/bvh.h"\n#include "shaders/shared/random.h"\n',
    "host/kinds/lights/point.cpp": '#include "scene/yaml/reader.h"\n#include "reference/ppm.h"\n',
    "host/kinds/lights/kinds.h": "",
    "host/scene/load/load_scene.h": '#include "scene/model/scene.h"\n#include "kinds/lights/kinds.h"\n',
    "host/geometry/bvh.h": '#include "box.h"\n#include "shaders/shared/scene_records.h"\n',
    "host/geometry/box.h": "",
    "host/scene/yaml/reader.h": '#include "scene/model/scene.h"\n',
    "host/scene/model/scene.h": "",
    "host/base/error.h": "",
    "shaders/shared/random.h": "",
    "shaders/shared/scene_records.h": "",
}
PLANTED = [
    ("host/base/error.h", '#include "cli/command.h"\n', "base stands before or beside cli"),
    ("host/gpu/context.h", '#include "reference/ppm.h"\n', "gpu stands before or beside reference"),
    ("host/reference/ppm.h", '#  include "../gpu/context.h"\n', "reference stands before or beside gpu"),
    ("host/reference/ppm.h", '#include "shaders/shared/scene_records.h"\n', "must not take"),
    ("host/reference/ppm.h", '#include "../../shaders/shared/scene_records.h"\n', "must not take"),
    ("host/render/ppm.h", "#include <vulkan/vulkan.h>\n", "Vulkan outside"),
    ("host/render/ppm.h", '#include "gpu/device.h"\n', "Vulkan outside"),
    ("host/scene/model/scene.h", '#include "scene/yaml/reader.h"\n', "scene/model stands before or beside scene/yaml"),
    ("host/reference/ppm.h", '#include "kinds/lights/kinds.h"\n', "reference stands before or beside kinds"),
    ("host/kinds/lights/point.cpp", '#include "render/ppm.h"\n', "kinds stands before or beside render"),
    ("host/kinds/lights/point.cpp", '#include "scene/load/load_scene.h"\n', "kinds stands before or beside scene/load"),
    ("host/scene/yaml/reader.h", '#include "scene/load/load_scene.h"\n', "scene stands before or beside scene/load"),
    ("host/scene/yaml/reader.h", '#include "kinds/lights/kinds.h"\n', "scene stands before or beside kinds"),
    ("host/render/integrators/whitted/whitted.h", '#include "render/ppm.h"\n', "render/integrators stands before or beside render/"),
    ("host/render/film/film.h", '#include "render/integrators/whitted/whitted.h"\n', "before or beside render/integrators"),
    ("host/render/film/film.h", '#include "render/photons/map.h"\n', "render/film stands before or beside render/photons"),
    ("host/extra/thing.h", "\n", "no place in the order"),
]
