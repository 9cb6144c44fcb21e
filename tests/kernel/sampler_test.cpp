// Every sampler draws from its stated distribution, on the device and in the reference: Pearson's test of draws with
// independent numbers. The theory is a mapping of the draws to the unit square that makes them uniform or, without one,
// analytic densities summed over cells.
#include "kernel/kernel_support.h"
#include "reference/bsdf/bsdf.h"
#include "reference/bsdf/ggx.h"
#include "reference/photons/photons.h"
#include "reference/photons/projection_map.h"
#include "scene/model/render_seed.h"
#include "support/statistics.h"
#include "unit/gpu/temporary_shaders.h"

#include <functional>

namespace hyalite::testing {

namespace {

using glm::dvec2;
using std::numbers::pi;

constexpr std::uint32_t kDraws = 100000;
constexpr std::uint32_t kLights = 6;
constexpr std::uint32_t kKinds = 8 + 2 * kLights;

struct DrawSamplesArguments {
    shared::LightArray lights;
    shared::MaterialArray materials;
    shared::ColorArray draws; // out: kKinds a thread
    std::uint32_t lightCount;
    std::uint32_t count;
};

constexpr const char* kKernel = R"(#version 460
#include "shared/kernel_arguments.h"
#include "bsdf/bsdf.glsl"
#include "lights/light.glsl"
#include "lib/thread.glsl"
struct Arguments {
    LightArray lights;
    MaterialArray materials;
    ColorArray draws;
    uint lightCount;
    uint count;
};
layout(push_constant, scalar) uniform Push { Arguments args; };
vec3 lobeDirection(uint material, Sampler s, uint dimension) {
    const vec3 up = vec3(0.0, 0.0, 1.0);
    return sampleLobe(lobeOf(args.materials.at[material], true), up, up, vec3(0.8, 0.0, 0.6),
                      sampleUnit(s, dimension), sampleUnit(s, dimension + 1u).x, kRadiance).direction;
}
void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    Sampler s = photonSampler(hash(i), 0u);
    uint first = i * (8u + 2u * args.lightCount);
    args.draws.at[first] = vec3(concentricDisc(sampleUnit(s, 0u)), 0.0);
    args.draws.at[first + 1u] = cosineHemisphere(sampleUnit(s, 1u), vec3(0.0, 0.0, 1.0));
    args.draws.at[first + 2u] = uniformSphere(sampleUnit(s, 2u));
    args.draws.at[first + 3u] = sampleVisibleNormal(vec3(0.8, 0.0, 0.6), 0.3, sampleUnit(s, 3u));
    for (uint material = 0u; material < 3u; ++material) {
        args.draws.at[first + 4u + material] = lobeDirection(material, s, 4u + 2u * material);
    }
    args.draws.at[first + 7u] = vec3(float(pickLight(args.lights, args.lightCount, sampleUnit(s, 10u).x)));
    for (uint light = 0u; light < args.lightCount; ++light) {
        LightRay ray = emitFrom(args.lights.at[light], sampleUnit(s, 11u + 2u * light), sampleUnit(s, 12u + 2u * light));
        args.draws.at[first + 8u + 2u * light] = ray.origin;
        args.draws.at[first + 9u + 2u * light] = ray.direction;
    }
}
)";

const dvec3 kUp(0, 0, 1);
const dvec3 kSlanted(0.8, 0, 0.6);

// The lights, in their order: a sky of four by two pixels, a spot, a quad, a disk, a sphere and a mesh; and the
// materials: rough glass, rough metal, clear glass.
Scene sampledScene() {
    Scene scene;
    reference::test::addMaterial(scene, Dielectric{1.5, 0.6});
    reference::test::addMaterial(scene, Conductor{dvec3(0.2), dvec3(3.9), 0.5});
    reference::test::addMaterial(scene, Dielectric{1.5});
    scene.environment = Environment{.image = Image(4, 2)};
    for (std::size_t i = 0; i < 8; ++i) {
        scene.environment->image.pixels[i] = glm::vec3(static_cast<float>(i));
    }
    scene.spots = {{.position = {1, 2, 3}, .direction = {0, 0, 1}, .intensity = dvec3(2), .angle = 60, .blend = 0.5}};
    reference::test::addObject(scene, Quad{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}}, 0, dvec3(1)); // faces +z, like the others
    reference::test::addObject(scene, Disk{{1, 2, 0}, {2, 0, 0}, {0, 1, 0}}, 1, dvec3(1));
    reference::test::addObject(scene, Sphere{{1, 1, 1}, 0.5}, 2, dvec3(1));
    scene.meshes = {{.file = {},
                     .positions = {{0, 0, 0}, {1, 0, 0}, {1, 0.4, 0}, {1, 1, 0}, {0, 1, 0}},
                     .normals = {},
                     .triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}, // of a square, by areas of 0.2, 0.3 and 0.5
                     .uvs = {},
                     .lines = {}}};
    reference::test::addObject(scene, MeshInstance{}, 0, dvec3(1));
    return scene;
}

dvec3 drawInReference(const reference::World& world, std::uint32_t i, std::uint32_t kind) {
    const shared::Sampler s = shared::photonSampler(shared::hash(i), 0);
    const auto numbers = [&](std::uint32_t dimension) { return reference::sampleUnitSquare(s, dimension); };
    switch (kind) {
    case 0:
        return {reference::concentricDisc(numbers(0)), 0};
    case 1:
        return reference::cosineHemisphere(numbers(1), kUp);
    case 2:
        return reference::uniformSphere(numbers(2));
    case 3:
        return reference::sampleVisibleNormal(kSlanted, 0.3, numbers(3));
    case 4:
    case 5:
    case 6: {
        const auto lobe = reference::lobeOf(world.materials[kind - 4].model, true).value();
        const auto sample = reference::sampleLobe(lobe, {kUp, kUp}, kSlanted, numbers(4 + 2 * (kind - 4)),
                                                  numbers(5 + 2 * (kind - 4)).x, reference::Transport::Radiance);
        return sample ? sample->direction : dvec3(0);
    }
    case 7:
        return dvec3(reference::chooseLight(world.lights, numbers(10).x));
    default: {
        const std::uint32_t light = (kind - 8) / 2;
        const auto ray = emitFrom(world.lights[light], numbers(11 + 2 * light), numbers(12 + 2 * light));
        return kind % 2 == 0 ? ray.origin : ray.direction;
    }
    }
}

// Cells, their probabilities, and the cell of a draw; a number beyond all cells: no draw should be there.
struct Theory {
    std::string name;
    std::vector<double> probabilities;
    std::function<std::size_t(const dvec3&)> cell;
};

constexpr std::size_t kSide = 16;

std::size_t squareCell(const dvec2& uv) {
    const auto index = [](double x) { return static_cast<std::size_t>(std::clamp(x, 0.0, 1 - 1e-9) * kSide); };
    return uv.x < -1e-5 || uv.x > 1 + 1e-5 || !(uv.y > -1e-5 && uv.y < 1 + 1e-5) ? kSide * kSide
                                                                                 : index(uv.x) * kSide + index(uv.y);
}

// A map to the unit square that makes the draws uniform.
Theory uniform(const std::string& name, const std::function<dvec2(const dvec3&)>& map) {
    return {name, std::vector<double>(kSide * kSide, 1.0 / (kSide * kSide)),
            [map](const dvec3& draw) { return squareCell(map(draw)); }};
}

double turns(double y, double x) {
    const double t = std::atan2(y, x) / (2 * pi);
    return t < 0 ? t + 1 : t;
}

// Share of a spot's flux within the angle of cosine `cosine` from its axis, in s = 1 - cos: even up to s0, then by
// 3 t^2 - 2 t^3 with t = (s1 - s) / (s1 - s0), whose integral from t to 1 is 1/2 - t^3 + t^4 / 2.
double spotShare(double cosine, double innerDegrees, double outerDegrees) {
    const double s = 1 - cosine;
    const double s0 = 1 - std::cos(innerDegrees * pi / 180);
    const double s1 = 1 - std::cos(outerDegrees * pi / 180);
    const double all = s0 + (s1 - s0) / 2;
    if (s <= s0) {
        return s / all;
    }
    const double t = (s1 - s) / (s1 - s0);
    return t < -1e-5 ? 2 : (s0 + (s1 - s0) * (0.5 - t * t * t + t * t * t * t / 2)) / all;
}

// By density on the sphere: cells of the cosine to +z and the azimuth, and a last one for what is absorbed, the zero
// vector.
Theory byDensity(const std::string& name, const std::function<double(const dvec3&)>& density) {
    Theory theory{name, std::vector<double>(kSide * kSide + 1, 0.0), [](const dvec3& w) {
                      const bool absorbed = w == dvec3(0);
                      return absorbed ? kSide * kSide : squareCell({(w.z + 1) / 2, turns(w.y, w.x)});
                  }};
    constexpr std::size_t kFine = 64 * kSide; // midpoints along each side
    double absorbed = 1;
    for (std::size_t i = 0; i < kFine; ++i) {
        for (std::size_t j = 0; j < kFine; ++j) {
            const dvec2 uv((static_cast<double>(i) + 0.5) / kFine, (static_cast<double>(j) + 0.5) / kFine);
            const double z = 2 * uv.x - 1;
            const double sine = std::sqrt(1 - z * z);
            const double p =
                density({sine * std::cos(2 * pi * uv.y), sine * std::sin(2 * pi * uv.y), z}) * 4 * pi / (kFine * kFine);
            theory.probabilities[squareCell(uv)] += p;
            absorbed -= p;
        }
    }
    theory.probabilities.back() = std::max(0.0, absorbed);
    return theory;
}

// [Heitz14], [Walter07]: G1(w) max(0, w . m) D(m) / w.z with D = a^2 / (pi ((a^2 - 1) cos^2 + 1)^2) and
// G1 = 2 / (1 + sqrt(1 + a^2 tan^2))
double visibleNormals(const dvec3& m) {
    constexpr double a2 = 0.09;
    const double D = m.z > 0 ? a2 / (pi * std::pow((a2 - 1) * m.z * m.z + 1, 2)) : 0;
    const double G1 = 2 / (1 + std::sqrt(1 + a2 * 16 / 9)); // tan of the slanted direction is 4/3
    return G1 * std::max(0.0, glm::dot(kSlanted, m)) * D / 0.6;
}

Theory ofLobe(const std::string& name, const MaterialModel& model) {
    return byDensity(name, [lobe = reference::lobeOf(model, true).value()](const dvec3& wi) {
        return evaluateLobe(lobe, {kUp, kUp}, kSlanted, wi, reference::Transport::Radiance).pdfW;
    });
}

// Pixels by their value times their solid angle, and in each any direction alike: even in height and azimuth.
Theory sky() {
    Theory theory{"direction from the sky", std::vector<double>(128, 0.0), [](const dvec3& w) {
                      const double height = (1 + w.y) / 2; // photons go -w: the upper row, seen upwards, is below
                      const double azimuth = 0.5 + std::atan2(-w.x, w.z) / (2 * pi);
                      const auto row = static_cast<std::size_t>(std::min(height * 8, 7.999));
                      return row * 16 + static_cast<std::size_t>(std::min(azimuth * 16, 15.999));
                  }};
    for (std::size_t i = 0; i < 128;
         ++i) { // 8 rows of 16 cells, 4 by 4 to a pixel; both rows have the same solid angle
        const std::size_t pixel = i / 16 / 4 * 4 + i % 16 / 4;
        theory.probabilities[i] = static_cast<double>(pixel) / 28 / 16;
    }
    return theory;
}

std::vector<Theory> theories(const reference::World& world) {
    const auto onSphere = [](const dvec3& w) { return dvec2((w.z + 1) / 2, turns(w.y, w.x)); };
    const auto aboutNormal = [](const dvec3& w) { return dvec2(w.z > 0 ? w.z * w.z : 2, turns(w.y, w.x)); };
    // Fresnel at cos 0.6: sin 0.8, inside 0.8 / 1.5
    const double inside = std::sqrt(1 - std::pow(0.8 / 1.5, 2));
    const double F = (std::pow((0.6 - 1.5 * inside) / (0.6 + 1.5 * inside), 2) +
                      std::pow((1.5 * 0.6 - inside) / (1.5 * 0.6 + inside), 2)) /
                     2;
    std::vector<double> shares;
    // Fluxes: of a grey sky pi R^2 times the integral of its radiance, 4 pi 3.5; of the spot
    // pi (2 - cos inner - cos outer) I; pi A L
    const double skyRadius = std::get<reference::SurroundingLight>(world.lights[0].shape).sphere.radius;
    const double fluxes[] = {pi * skyRadius * skyRadius * 4 * pi * 3.5,
                             2 * pi * (2 - std::cos(pi / 6) - std::cos(pi / 3)),
                             2 * pi,
                             2 * pi * pi,
                             pi * pi,
                             pi};
    double sum = 0;
    for (const double flux : fluxes) {
        sum += flux;
    }
    for (const double flux : fluxes) {
        shares.push_back(flux / sum / 2 + 0.5 / kLights); // half of the picks by flux, half even
    }
    // Across each direction of the sky a disc; the middle of the scene is its centre, the distance of no matter
    return {uniform("disc", [](const dvec3& p) { return dvec2(glm::dot(p, p), turns(p.y, p.x)); }),
            uniform("cosine hemisphere", aboutNormal),
            uniform("sphere", onSphere),
            byDensity("visible normal", visibleNormals),
            ofLobe("rough glass", Dielectric{1.5, 0.6}),
            ofLobe("rough metal", Conductor{dvec3(0.2), dvec3(3.9), 0.5}),
            {"clear glass", {F, 1 - F}, [](const dvec3& w) { return w.z > 0 ? std::size_t{0} : std::size_t{1}; }},
            {"light", shares, [](const dvec3& p) { return static_cast<std::size_t>(p.x); }},
            {"", {}, {}}, // where photons of the sky start depends on where they go
            sky(),
            {"", {}, {}}, // the place of the spot
            uniform("direction from the spot",
                    [](const dvec3& w) { return dvec2(spotShare(w.z, 30, 60), turns(w.y, w.x)); }),
            uniform("place on the quad", [](const dvec3& p) { return dvec2((p.x - p.y) / 2, p.y); }),
            uniform("direction from the quad", aboutNormal),
            uniform("place on the disk",
                    [](const dvec3& p) {
                        const dvec2 at((p.x - 1) / 2, p.y - 2);
                        return dvec2(glm::dot(at, at), turns(at.y, at.x));
                    }),
            uniform("direction from the disk", aboutNormal),
            uniform("place on the sphere", [=](const dvec3& p) { return onSphere((p - dvec3(1)) / 0.5); }),
            {"", {}, {}}, // about the normal of that place: as from the disk
            uniform("place on the mesh", [](const dvec3& p) { return dvec2(p); }),
            uniform("direction from the mesh", aboutNormal)};
}

std::vector<std::uint32_t> histogram(const Theory& theory, const std::function<dvec3(std::uint32_t)>& draw,
                                     std::uint32_t draws) {
    std::vector<std::uint32_t> counts(theory.probabilities.size() + 1, 0); // the last: nowhere
    for (std::uint32_t i = 0; i < draws; ++i) {
        ++counts[std::min(theory.cell(draw(i)), counts.size() - 1)];
    }
    return counts;
}

Verdict follows(FalseAlarms& alarms, const Theory& theory, const std::function<dvec3(std::uint32_t)>& draw,
                std::uint32_t draws = kDraws) {
    std::vector<double> probabilities = theory.probabilities;
    probabilities.push_back(0);
    return alarms.counts(histogram(theory, draw, draws), probabilities);
}

} // namespace

TEST_CASE("every sampler draws from its stated distribution, on both sides") {
    BothSides both(sampledScene());
    REQUIRE(both.deviceScene.lightCount == kLights);
    const TemporaryShaders folder;
    folder.write("kernels/draw_samples.comp", kKernel);
    const gpu::Kernel kernel(both.device.context, both.device.tables, gpu::ShaderCompiler(folder.shaders()),
                             "draw_samples", both.deviceScene.specialization);
    const auto draws = both.room<vec3>(std::size_t{kDraws} * kKinds);
    both.device.commands.run(
        kernel, DrawSamplesArguments{both.deviceScene.lights, both.deviceScene.materials, draws, kLights, kDraws},
        kDraws);
    both.device.commands.finish();
    const std::vector<Theory> all = theories(both.world);
    REQUIRE(all.size() == kKinds);
    FalseAlarms alarms(2 * all.size());
    for (std::uint32_t kind = 0; kind < kKinds; ++kind) {
        if (all[kind].name.empty()) {
            continue;
        }
        INFO(all[kind].name);
        CHECK(follows(alarms, all[kind],
                      [&](std::uint32_t i) { return dvec3(draws.host()[std::size_t{i} * kKinds + kind]); }));
        CHECK(follows(alarms, all[kind], [&](std::uint32_t i) { return drawInReference(both.world, i, kind); }));
    }
}

TEST_CASE("camera rays start uniformly over the lens, aimed photons are uniform in the cone about their target") {
    Scene scene;
    scene.camera.aperture = 0.5;
    scene.camera.resolution = {320, 320};
    scene.lights = {{{0, 0, 2}, dvec3(1)}};
    scene.render.photons = kDraws;
    reference::test::addObject(scene, Sphere{{0, 0, 0}, 0.5}, reference::test::addMaterial(scene, Dielectric{1.5}));
    BothSides both(scene);
    const std::uint32_t pixels = 320 * 320;
    FalseAlarms alarms(4);
    // The camera stands at (0, 0, 5) and looks along -z
    const Theory lens = uniform("lens", [](const dvec3& p) {
        const dvec2 at = dvec2(p) / 0.25;
        return dvec2(glm::dot(at, at), turns(at.y, at.x));
    });
    const auto rays = both.room<shared::Ray>(std::max(pixels, kDraws));
    const auto cameraPaths = both.room<shared::CameraPath>(pixels);
    both.run("generate_camera_rays",
             shared::GenerateCameraRaysArguments{rays, cameraPaths, renderSeed(both.scene.render),
                                                 both.deviceScene.camera, pixels, 0},
             pixels);
    CHECK(follows(alarms, lens, [&](std::uint32_t i) { return dvec3(rays.host()[i].origin); }, pixels));
    CHECK(follows(
        alarms, lens, [&](std::uint32_t i) { return reference::generateCameraRay(both.world, i, 0).origin; }, pixels));

    // From (0, 0, 2) about -z: what meets the sphere about the target is even in the cosine up to its rim
    REQUIRE(both.world.targets.size() == 1);
    const double sine = both.world.targets[0].radius / 2;
    const double rim = 1 - std::sqrt(1 - sine * sine);
    const Theory cone = uniform("cone", [=](const dvec3& w) { return dvec2((1 + w.z) / rim, turns(w.y, w.x)); });
    const auto photonPaths = both.room<shared::PhotonPath>(kDraws);
    both.run("emit_caustic_photons",
             shared::EmitCausticPhotonsArguments{both.deviceScene.lights, both.deviceScene.targets, rays, photonPaths,
                                                 0, kDraws, kDraws, 1, 1, 7},
             kDraws);
    CHECK(follows(alarms, cone, [&](std::uint32_t i) { return dvec3(rays.host()[i].direction); }));
    const reference::PhotonPass pass{.sequence = 7, .count = kDraws, .kinds = 4, .aimed = true};
    CHECK(follows(alarms, cone, [&](std::uint32_t i) {
        return reference::emitAimedPhoton(both.world, shared::hash(i), pass).ray.direction;
    }));
}

} // namespace hyalite::testing
