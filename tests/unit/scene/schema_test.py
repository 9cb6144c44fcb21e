"""The JSON Schema accepts every scene that is shipped, and refuses what the loader refuses. Argument: the source folder."""

import copy
import json
import pathlib
import sys

import jsonschema
import yaml

source = pathlib.Path(sys.argv[1])
schema = json.loads((source / "scenes/hyalite.schema.json").read_text())
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)

scenes = sorted((source / "scenes").rglob("*.yaml"))
assert len(scenes) >= 5, scenes
for path in scenes:
    for error in validator.iter_errors(yaml.safe_load(path.read_text())):
        sys.exit(f"{path}: {error.json_path}: {error.message}")

GOOD = {
    "hyalite": 1,
    "camera": {"fov": 40, "resolution": [640, 480], "aperture": 0.1, "focus_distance": 2},
    "textures": {"c": {"type": "checker", "colors": [0, [1, 1, 1]], "size": 2, "space": "uv"},
                 "i": {"type": "image", "file": "i.png", "encoding": "linear"},
                 "g": {"type": "custom", "file": "g.glsl", "parameters": [1, 2]}},
    "render": {"integrator": "whitted", "max_depth": 0, "radius": 0, "caustic_radius": 1e-9, "sampler": "independent",
               "structure": "grid", "filter": "custom", "filter_file": "f.glsl", "caustic_photons": 0,
               "projection_map": False, "view": "radius", "shadow_photons": 64, "target_error": 0.5},
    "materials": {
        "m": {"type": "diffuse", "albedo": 0.5},
        "t": {"type": "mirror", "reflectance": {"texture": "c"}},
        "g": {"type": "dielectric", "absorption": [0, 1, 2]},
        "gold": {"type": "conductor", "metal": "gold", "roughness": 0.3},
        "tin": {"type": "conductor", "eta": 1.5, "k": [5, 5, 4.5]},
        "frosted": {"type": "dielectric", "roughness": 0.2},
        "paint": {"type": "metallic_roughness", "base_color": [1, 0, 0], "metallic": 0.5, "roughness": 1},
        "own": {"type": "custom", "file": "own.glsl", "parameters": [1, 2], "roughness": 0.2},
        "worn": {"type": "metallic_roughness", "base_color": {"texture": "c"},
                 "metallic_roughness_texture": {"texture": "i"}},
    },
    "lights": [{"type": "point", "position": [0, 1, 0], "intensity": [1, 1, 1], "photon_share": 2},
               {"type": "spot", "position": [0, 1, 0], "direction": [0, -1, 0], "angle": 180, "blend": 0},
               {"type": "directional", "direction": [0, -1, 0], "radius": 0.5, "center": [0, 3, 0]},
               {"type": "environment", "image": "sky.exr", "scale": 2, "rotation": 90}],
    "objects": [
        {"shape": {"type": "sphere", "radius": 1}, "material": "m", "transform": [{"scale": 2}]},
        {"shape": {"type": "quad", "corner": [0, 0, 0], "edges": [[1, 0, 0], [0, 1, 0]]}, "emission": 1,
         "photon_share": 0.5},
        {"shape": {"type": "cone", "base": [0, 0, 0], "top": [0, 1, 0], "radius": 1, "open": True}, "material": "m"},
        {"shape": {"type": "quadric", "coefficients": [1, 0, 0, 0, 1, 0, 0, 1, 0, -1],
                   "clip": {"min": [None, 0, None]}, "caps": False}, "material": "m"},
        {"shape": {"type": "csg", "op": "difference", "cut_material": "m",
                   "shapes": [{"type": "csg", "op": "union",
                               "left": {"type": "ellipsoid", "radii": [1, 2, 3], "transform": [{"scale": 2}]},
                               "right": {"type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "m"}},
                              {"type": "box", "min": [0, 0, 0], "max": [1, 1, 1]}]}},
        {"shape": {"type": "sphere", "radius": 1, "material": "m"}},
    ],
}
for error in validator.iter_errors(GOOD):
    sys.exit(f"the good scene: {error.json_path}: {error.message}")

# A path into the scene and what makes it wrong there; None removes the key.
MISTAKES = [
    (["hyalite"], 2), (["hyalite"], None), (["objects"], []), (["objects"], None), (["unheardof"], 1),
    (["camera", "fov"], 0), (["camera", "fov"], 180), (["camera", "fov"], "40"), (["camera", "fow"], 40),
    (["camera", "resolution"], [0, 480]), (["camera", "resolution"], [640]), (["camera", "resolution"], [640, 65537]),
    (["camera", "aperture"], -1), (["camera", "focus_distance"], 0),
    (["textures", "c", "colors"], [0]), (["textures", "c", "colors"], [0, 2]), (["textures", "c", "size"], 0),
    (["textures", "c", "space"], "object"), (["textures", "c", "type"], "noise"), (["textures", "i", "file"], None),
    (["textures", "i", "encoding"], "gamma"), (["materials", "t", "reflectance"], {"texture": "c", "scale": 2}),
    (["materials", "g", "absorption"], -1), (["materials", "g", "absorption"], {"texture": "c"}),
    (["camera", "position"], [0, 1]), (["camera", "position"], [0, 1, 1e10]),
    (["render", "integrator"], "pmm"), (["render", "max_depth"], 255), (["render", "passes"], 0),
    (["render", "photons"], 16777217), (["render", "radius"], -1), (["render", "alpha"], 1),
    (["render", "integrator"], "ppm"),  # with max_depth 0
    (["render", "integrator"], None),  # and so without, as ppm is the default
    (["render", "radius"], 1e-30), (["render", "caustic_radius"], -1), (["render", "sampler"], "random"),
    (["render", "structure"], "tree"), (["render", "filter"], "box"), (["render", "filter_file"], ["f.glsl"]),
    (["render", "projection_map"], 0), (["render", "view"], "all"), (["render", "shadow_photons"], 65),
    (["render", "caustic_photons"], 0.5), (["render", "target_error"], -1), (["render", "gather"], 1),
    (["camera", "up"], [0, 1, "up"]), (["camera", "resolution"], "640x480"),
    (["materials", "m", "albedo"], 1.1), (["materials", "m", "type"], "velvet"), (["materials", "m", "ior"], 1.5),
    (["materials", "gold", "eta"], 1), (["materials", "gold", "metal"], "tin"), (["materials", "gold", "metal"], None),
    (["materials", "gold", "roughness"], 1.5), (["materials", "tin", "k"], None), (["materials", "tin", "eta"], 0),
    (["materials", "frosted", "roughness"], -1), (["materials", "paint", "metallic"], 2),
    (["materials", "paint", "base_color"], [1, 0, 1.1]), (["materials", "paint", "ior"], 1.5),
    (["materials", "worn", "metallic_roughness_texture"], "i"),
    (["lights", 0, "intensity"], [1, -1, 1]), (["lights", 0, "position"], None), (["lights", 0, "type"], "lamp"),
    (["lights", 0, "photon_share"], 0), (["lights", 1, "direction"], None), (["lights", 1, "angle"], 181),
    (["lights", 1, "blend"], 1.5), (["lights", 2, "radius"], None),  # with a center
    (["lights", 2, "radius"], 0), (["lights", 3, "radiance"], 1),  # beside an image
    (["lights", 3, "image"], ""), (["lights", 3, "scale"], -1), (["objects", 1, "photon_share"], 1001),
    (["objects", 0, "material"], None), (["objects", 0, "emission"], -1), (["objects", 0, "shape", "radius"], 0),
    (["objects", 0, "shape", "radius"], None), (["objects", 0, "shape", "type"], "cube"),
    (["objects", 0, "transform"], {"scale": 2}), (["objects", 0, "transform", 0, "translate"], [0, 0, 0]),
    (["objects", 1, "shape", "edges"], [[1, 0, 0]]), (["objects", 1, "emission"], -1),
    (["objects", 1, "shape"], {"type": "box", "min": [0, 0, 0], "max": [1, 1, 1]}),
    (["objects", 1, "shape"], {"type": "mesh", "file": "teapot.fbx"}),
    (["objects", 2, "shape", "radius"], -1), (["objects", 2, "shape", "open"], 1), (["objects", 2, "shape", "caps"], True),
    (["objects", 3, "shape", "coefficients"], [1, 2, 3]), (["objects", 3, "shape", "clip"], None),  # caps without a clip
    (["objects", 3, "shape", "clip"], {}), (["objects", 3, "shape", "clip", "min"], [None, 0]),
    (["objects", 4, "shape", "op"], "union"),  # with a cut_material
    (["objects", 4, "shape", "op"], "xor"), (["objects", 4, "shape", "shapes"], None),
    (["objects", 4, "shape", "shapes", 1], {"type": "disk", "normal": [0, 1, 0], "radius": 1}),
    (["objects", 4, "shape", "shapes", 1], {"type": "quad", "corner": [0, 0, 0], "edges": [[1, 0, 0], [0, 1, 0]]}),
    (["objects", 4, "shape", "shapes", 0, "right"], None), (["objects", 4, "shape", "shapes", 0, "left", "radius"], 1),
    (["objects", 4, "shape", "left"], {"type": "sphere", "radius": 1}),  # beside shapes
    (["objects", 4, "shape", "shapes", 0, "left", "transform"], {"scale": 2}),
    (["objects", 5, "shape", "material"], None),
]
for path, wrong in MISTAKES:
    bad = copy.deepcopy(GOOD)
    place = bad
    for step in path[:-1]:
        place = place[step]
    if wrong is None:
        del place[path[-1]]
    else:
        place[path[-1]] = wrong
    assert not validator.is_valid(bad), (path, wrong)
