"""hyalite parity and hyalite inspect: what agrees passes, what does not is found, and where."""

import json
import re
import time

from program import USAGE, CliTest, Setup, scene_file



def small(passes=1, photons=1024):
    return ("--resolution", "32x32", "--passes", passes, "--photons", photons)


SMALL = small()
BAR = 60  # [s] for a scene at its test size


class Scenes(CliTest):
    def test_the_sides_agree_on_every_shipped_scene_within_a_minute(self):
        scenes = sorted((Setup.source / "scenes").rglob("*.yaml"))
        self.assertGreater(len(scenes), 10)
        for scene in scenes:
            with self.subTest(scene=scene.name):
                begin = time.monotonic()
                result = self.succeed_json("parity", scene)
                self.assertTrue(result["passed"])
                self.assertLess(time.monotonic() - begin, BAR)
                for paths in result["paths"].values():
                    # Roundings grow tenfold at each curved surface: in teapots of glass, 2 paths in a hundred part
                    self.assertGreaterEqual(paths["share"], 0.999 if scene.name == "cornell-caustics.yaml" else 0.97)
                    self.assertEqual(paths["unexplained"], 0)


class Comparison(CliTest):
    def test_every_kernel_has_a_twin_that_some_test_scene_asks(self):
        kernels = {path.stem for path in (Setup.source / "shaders/kernels").glob("*.comp")}
        # self_test has known answers, nearest_photons is asked by tests alone
        kernels -= {"self_test", "nearest_photons"}
        seen = set()
        runs = [
            ("cornell-box.yaml",),
            ("cornell-box.yaml", "--set", "render.shadow_photons=8", "--set", "render.structure=grid"),
            ("cornell-box.yaml", "--set", "render.view=photons"),
            ("glass-ball.yaml",),
            ("metals.yaml",),
            ("reflections.yaml",),
        ]
        for scene, *options in runs:
            result = self.succeed_json("parity", scene_file(scene), *small(photons=2048), *options)
            seen |= {stage["name"] for stage in result["stages"] if stage["has_twin"]}
        self.assertEqual(kernels - seen, set())

    def test_stages_can_be_chosen(self):
        result = self.succeed_json("parity", scene_file("cornell-caustics.yaml"), *SMALL, "--stages", "trace_closest,sample_lights")
        self.assertEqual({stage["name"] for stage in result["stages"]}, {"trace_closest", "sample_lights"})
        self.assertNotIn("picture", result)

    def test_text_ends_in_one_line_of_verdict(self):
        said = self.succeed("parity", scene_file("cornell-caustics.yaml"), *SMALL)
        self.assertTrue(said.splitlines()[-1].startswith("parity passed: "), said)
        self.assertIn("trace_closest", said)


class Inspect(CliTest):
    def test_both_sides_of_a_pixels_path_are_shown(self):
        said = self.succeed("inspect", scene_file("cornell-caustics.yaml"), *SMALL, "--pixel", "16,16", "--pass", "3")
        self.assertRegex(said, r"(?s)vertex 1.*device.*position.*throughput.*chosen.*twin.*random numbers")
        self.assertIn("pixel 16, 16, pass 3: both sides agree", said)

    def test_both_sides_of_a_photons_path_are_shown(self):
        said = self.succeed("inspect", scene_file("cornell-caustics.yaml"), *SMALL, "--photon", "7")
        self.assertRegex(said, r"(?s)vertex 1.*flux.*photon 7: ")

    def test_what_is_not_there_is_refused(self):
        scene = scene_file("cornell-caustics.yaml")
        self.assert_refused(USAGE, ["one pixel or one photon"], ["inspect", scene])
        self.assert_refused(USAGE, ["32 x 32"], ["inspect", scene, *SMALL, "--pixel", "32,0"])
        self.assert_refused(USAGE, ["no photon 1024"], ["inspect", scene, *SMALL, "--photon", "1024"])


class Report(CliTest):
    def test_the_report_is_one_page_that_needs_no_network(self):
        self.succeed("parity", scene_file("cornell-caustics.yaml"), "--report", "found")
        page = (self.folder / "found/parity.html").read_text()
        self.assertLess(len(page), 5_000_000)
        self.assertNotRegex(page, r"@[A-Z]+@")  # every place of the template is filled
        addresses = set(re.findall(r"https?://[^\s\"'<>]+", page))
        self.assertEqual(addresses, {"http://www.w3.org/2000/svg"})  # a name, not an address
        data = re.search(r"^const pixels = (.*);$", page, re.MULTILINE)
        self.assertEqual(len(json.loads(data[1])), 64 * 64)


CAUSTICS, METALS, BOX, TEAPOT = "cornell-caustics.yaml", "metals.yaml", "cornell-box.yaml", "glass-teapot.yaml"

# What is wrong, where, the text there, what stands in its place, a scene that shows it, and the stage where it shows.
FAULTS = [
    ("picture upside down", "kernels/generate_camera_rays.comp", "vec2(2.0, -2.0)", "vec2(2.0, 2.0)", CAUSTICS,
     "generate_camera_rays"),
    ("every ray through the middle of its pixel", "kernels/generate_camera_rays.comp", "camera.width) + inPixel",
     "camera.width) + 0.5", CAUSTICS, "generate_camera_rays"),
    ("lens that focuses behind the camera", "kernels/generate_camera_rays.comp", "direction -= onLens",
     "direction += onLens", "globe.yaml", "generate_camera_rays"),
    ("far root of the sphere", "lib/shapes.glsl", "roots.x > 0.0 ? roots.x : roots.y", "roots.y", CAUSTICS,
     "trace_closest"),
    ("quads that end too early", "lib/shapes.glsl", "greaterThan(uv, vec2(1.0))", "greaterThan(uv, vec2(0.9))", CAUSTICS,
     "trace_closest"),
    ("barycentric coordinates swapped", "lib/mesh.glsl", "uv = w.yz /", "uv = w.zy /", TEAPOT, "trace_closest"),
    ("box entered at the wrong side", "lib/bvh.glsl", "bytes(backward.x ? low.w : low.x)", "bytes(low.w)", TEAPOT,
     "trace_closest"),
    ("wrong sign in reflection", "lib/dielectric.glsl", "d - 2.0 * dot(n, d) * n", "d + 2.0 * dot(n, d) * n", CAUSTICS,
     "shade_surface"),
    ("indices of refraction swapped", "lib/bsdf.glsl", "front ? 1.0 / material.ior : material.ior",
     "front ? material.ior : 1.0 / material.ior", CAUSTICS, "shade_surface"),
    ("half of Fresnel's equations", "lib/dielectric.glsl", "0.5 * (s * s + p * p)", "s * s", "tests/mirror-and-glass.yaml",
     "shade_surface"),
    ("radiance not scaled by the squared indices", "lib/bsdf.glsl", "radiance ? lobe.eta * lobe.eta : 1.0", "1.0",
     CAUSTICS, "shade_surface"),
    ("2 pi for pi under the diffuse reflectance", "lib/math.glsl", "kInvPi = 0.318309886183791",
     "kInvPi = 0.159154943091895", CAUSTICS, "shade_surface"),
    ("normal of a sphere not normalised", "lib/surface.glsl", "normalize(p - sphere.xyz)", "(p - sphere.xyz)", CAUSTICS,
     "shade_surface"),
    ("next ray starts on the wrong side", "lib/surface.glsl", "(side * s.error)", "(-side * s.error)", CAUSTICS,
     "shade_surface"),
    ("visible point under its surface", "kernels/shade_surface.comp", "s.position + s.error * s.geometricNormal",
     "s.position - s.error * s.geometricNormal", CAUSTICS, "shade_surface"),
    ("glass that absorbs half as much", "lib/medium.glsl", ".extinction * distance", ".extinction * (0.5 * distance)",
     "globe.yaml", "shade_surface"),
    ("squares of a checker swapped", "lib/texture.glsl", "? rest.yzw : head.yzw", "? head.yzw : rest.yzw", "globe.yaml",
     "shade_surface"),
    ("pi for 2 pi in angles", "lib/math.glsl", "* (2.0 * kPi)", "* kPi", METALS, "shade_surface"),
    ("distribution of microfacets not squared", "lib/ggx.glsl", "alpha * t * t)", "alpha * t)", METALS, "shade_surface"),
    ("masking twice as strong", "lib/ggx.glsl", "return 0.5 * (slant", "return (slant", METALS, "shade_surface"),
    ("balance for power heuristic", "lib/bsdf.glsl", "1.0 / (1.0 + ratio * ratio)", "1.0 / (1.0 + ratio)", METALS,
     "sample_rough_lights"),
    ("missing cosine at the light", "lib/light.glsl", "light.emission * (cosLight * areaFacing(light) / distance2)",
     "light.emission * (areaFacing(light) / distance2)", CAUSTICS, "sample_lights"),
    ("missing cosine at the surface", "kernels/sample_lights.comp", "toLight.irradiance * cosine /",
     "toLight.irradiance /", CAUSTICS, "sample_lights"),
    ("probability of the light forgotten", "kernels/sample_lights.comp", "(one ? light.pmf : 1.0)", "1.0", METALS,
     "sample_lights"),
    ("shadow ray that does not end at the light", "kernels/trace_shadow.comp", "traceScene(args.rootNode, ray, true)",
     "traceScene(args.rootNode, Ray(ray.origin, kInfinity, ray.direction, ray.from), true)", CAUSTICS, "trace_shadow"),
    ("each photon carries all flux", "kernels/emit_photons.comp", "light.pmf * float(args.count)", "light.pmf", CAUSTICS,
     "emit_photons"),
    ("sine for cosine in the disc", "lib/sampling.glsl", "p.x * sc.yx", "p.x * sc.xy", CAUSTICS, "emit_photons"),
    ("survivors of roulette not made up for", "kernels/scatter_photon.comp", "next.weight / survival;", "next.weight;",
     CAUSTICS, "scatter_photon"),
    ("every photon behind glass a caustic", "kernels/scatter_photon.comp",
     "path.kind == kPhotonDirect ? kPhotonCaustic : path.kind", "kPhotonCaustic", CAUSTICS, "scatter_photon"),
    ("photons remember where they went", "kernels/scatter_photon.comp", "packUnitVector(-direction,",
     "packUnitVector(direction,", CAUSTICS, "scatter_photon"),
    # Not more than this: sums that are far off send kernels out of their buffers, and that may end the program
    ("last value of all left out of its chunk", "kernels/sum_chunks.comp", "min(begin + kScanChunk, args.count)",
     "min(begin + kScanChunk, args.count - 1u)", CAUSTICS, "sum_chunks"),
    ("last of the living lost", "kernels/scan_chunks.comp", "args.sums.at[end] = sum;",
     "args.sums.at[end] = sum - min(sum, 1u);", CAUSTICS, "scan_chunks"),
    ("compaction that leaves the paths behind", "kernels/compact_camera_paths.comp", "args.nextPaths.at[i]",
     "args.nextPaths.at[to]", CAUSTICS, "compact_camera_paths"),
    ("cells rounded to the nearest", "lib/grid.glsl", "floor(position * grid.inverseCellSize)",
     "round(position * grid.inverseCellSize)", CAUSTICS, "count_cells"),
    ("counting that races", "kernels/count_cells.comp", "atomicAdd(args.cellCounts.at[bucket], 1u)",
     "args.cellCounts.at[bucket]++", CAUSTICS, "count_cells"),
    ("every other photon listed twice", "kernels/fill_cells.comp", "args.ranks.at[i]] = i", "args.ranks.at[i]] = i & ~1u",
     CAUSTICS, "fill_cells"),
    ("buckets in falling order", "kernels/order_cells.comp", "if (before <= value)", "if (before >= value)", CAUSTICS,
     "order_cells"),
    ("off by one in the grid", "lib/grid.glsl", "takeSecond && !wraps ? 2u : 1u", "1u", CAUSTICS, "gather_radiance"),
    ("2 pi for pi in the density", "kernels/gather_radiance.comp", "(kPi * args.radius", "(2.0 * kPi * args.radius",
     CAUSTICS, "gather_radiance"),
    ("filter without its mean", "kernels/estimate_radiance.comp", "1.0 - 2.0 / (3.0 * args.filterConstant)", "1.0",
     "glass-ball.yaml", "estimate_radiance"),
    ("kd-tree split along the first axis", "lib/kdtree.glsl", "if (high - low > longest)",
     "if (high - low > longest && axis == 0u)", BOX, "split_nodes"),
    ("gathering rays twice as bright", "kernels/start_gather_rays.comp", "x.f * (kPi *", "x.f * (2.0 * kPi *", BOX,
     "start_gather_rays"),
    ("emission lost in the sum", "kernels/sum_paths.comp", "args.emitted.at[i] + args.direct.at[i]",
     "args.direct.at[i]", CAUSTICS + " --integrator whitted", "sum_paths"),
    ("passes summed, not averaged", "kernels/resolve_film.comp", "* args.scale", "* 1.0", CAUSTICS, "resolve_film"),
]


def named(scene):
    """A scene's file, and the options behind its name."""
    name, *options = scene.split()
    return (scene_file(name), *options)


def copy_shaders(to):
    """The shaders, as they are, in a folder of their own."""
    source = Setup.source / "shaders"
    for path in source.rglob("*"):
        if path.suffix in (".comp", ".glsl", ".h"):
            copied = to / path.relative_to(source)
            copied.parent.mkdir(parents=True, exist_ok=True)
            copied.write_bytes(path.read_bytes())
    return to


class PlantedFaults(CliTest):
    def test_every_planted_fault_is_found_at_the_right_stage(self):
        self.assertGreaterEqual(len(FAULTS), 20)
        shaders = copy_shaders(self.folder / "shaders")
        for name, file, right, wrong, scene, stage in FAULTS:
            with self.subTest(fault=name):
                path = shaders / file
                original = path.read_text()
                self.assertIn(right, original, f"{file} has changed: plant the fault anew")
                path.write_text(original.replace(right, wrong, 1))
                options = small(passes=2 if stage == "resolve_film" else 1, photons=4096 if stage == "split_nodes" else 1024)
                result = self.run_program("parity", *named(scene), *options, "--shaders", shaders, "--json")
                path.write_text(original)
                self.assertEqual((result.returncode, result.stderr), (1, ""))
                found = json.loads(result.stdout)
                self.assertFalse(found["passed"])
                self.assertEqual(found["first_failure"], stage, found["verdict"])

    def test_without_a_fault_the_same_runs_pass(self):
        shaders = copy_shaders(self.folder / "shaders")
        for scene in sorted({fault[4] for fault in FAULTS}):
            with self.subTest(scene=scene):
                self.succeed_json("parity", *named(scene), *SMALL, "--shaders", shaders)
