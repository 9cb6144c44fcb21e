// The kernels of photon mapping that are its own, against their twins.
#include "kernel/kernel_support.h"
#include "kernel/visible_points.h"
#include "reference/bsdf/fresnel.h"
#include "reference/photons/photons.h"
#include "reference/photons/projection_map.h"
#include "reference/photons/shadow_photons.h"
#include "render/film/scene_identity.h"
#include "render/photons/photon_maps.h"
#include "render/photons/photon_paths.h"
#include "render/photons/photon_slots.h"
#include "render/photons/shadow_photons.h"

#include <algorithm>
#include <array>
#include <bit>
#include <set>
#include <tuple>

namespace hyalite::testing {

namespace {

// Point, quad, disk, sphere: one light far off, one near the glass, one inside the mirror's bounding sphere.
Scene litBox() {
    Scene scene = reference::test::cornellBox();
    scene.lights = {{{0.2, 0.5, 0.1}, {1, 2, 3}}, {{-0.42, -0.3, -0.25}, {0.4, 0.1, 0.2}}};
    reference::test::addObject(scene, Disk{{0.5, 0.9, -0.5}, {0.2, 0, 0}, {0, 0.05, 0.3}}, std::nullopt, {5, 5, 2});
    reference::test::addObject(scene, Sphere{{-0.5, 0.5, 0.5}, 0.15}, std::nullopt, {2, 6, 3});
    return scene;
}

// A torus and a ball of glass whose spheres overlap from most sides, and a light within the torus' hole.
Scene overlapping() {
    Scene scene = litBox();
    reference::test::addObject(scene, Torus{0.3, 0.08, glm::translate(glm::dmat4(1), dvec3(-0.3, 0.1, 0))}, 4);
    reference::test::addObject(scene, Sphere{{-0.2, 0.15, 0.2}, 0.2}, 4);
    scene.lights.push_back({{-0.3, 0.1, 0}, dvec3(1)});
    return scene;
}

struct Emitted {
    std::vector<shared::Ray> rays;
    std::vector<shared::PhotonPath> paths;
};

Emitted emitCausticPhotons(BothSides& both, const reference::PhotonPass& pass) {
    const auto rays = both.room<shared::Ray>(pass.count);
    const auto paths = both.room<shared::PhotonPath>(pass.count);
    both.run("emit_caustic_photons",
             shared::EmitCausticPhotonsArguments{both.deviceScene.lights, both.deviceScene.targets, rays, paths, 0,
                                                 pass.count, pass.count, both.deviceScene.lightCount,
                                                 both.deviceScene.targetCount, pass.sequence},
             pass.count);
    return {rays.read(), paths.read()};
}

reference::PhotonPass causticPass(std::uint32_t count) {
    return {.sequence =
                shared::photonSequence(shared::renderSeed(1, shared::kSobolNumbers), shared::kCausticPhotons, 0),
            .count = count,
            .kinds = reference::kindBit(reference::PhotonKind::Caustic),
            .aimed = true};
}

double meanOf(const vec3& c) {
    return (double{c.x} + c.y + c.z) / 3;
}

// Notes the names of the kernels that run.
class NamesOfKernels : public gpu::DispatchObserver {
public:
    std::set<std::string> names;

    void before(const gpu::Dispatch& dispatch) override { names.insert(dispatch.kernel.name()); }
    void after(const gpu::Dispatch& /*dispatch*/) override {}
    [[nodiscard]] bool readsBuffers() const override { return false; }
};

} // namespace

TEST_CASE("the identity of photons knows every kernel that traces them") {
    Scene scene = litBox();
    scene.render.integrator = Integrator::PhotonMap;
    scene.render.photons = 200;
    scene.render.photonMap.causticPhotons = 200;
    scene.render.photonMap.shadowPhotons = 2;
    BothSides both(scene);
    render::PhotonMaps maps(both.device, both.scene, both.deviceScene);
    NamesOfKernels traced;
    both.device.commands.observe(&traced);
    maps.trace();
    both.device.commands.observe(nullptr);
    CHECK(traced.names.size() > 4);
    for (const std::string& name : traced.names) {
        INFO(name);
        CHECK(std::ranges::count(render::kernelsOfPhotons(), name) == 1);
    }
}

TEST_CASE("aimed photons leave the lights as in the reference") {
    for (const Scene& scene : {litBox(), overlapping()}) {
        BothSides both(scene);
        const reference::PhotonPass pass = causticPass(20000);
        const Emitted emitted = emitCausticPhotons(both, pass);
        std::size_t parted = 0;
        for (std::uint32_t i = 0; i < pass.count; ++i) {
            const reference::Emission expected = reference::emitPhoton(both.world, i, pass);
            const double strength = glm::length(expected.power);
            // At the rim of a cone or of the lamp's horizon a photon is in on one side only, or has another overlap
            if (emitted.paths[i].light != expected.light ||
                distance(emitted.paths[i].power, expected.power) > 1e-3 * strength ||
                distance(emitted.rays[i].direction, expected.ray.direction) > 1e-4) {
                ++parted;
                continue;
            }
            CHECK(distance(emitted.rays[i].origin, expected.ray.origin) < 1e-5);
            CHECK((emitted.rays[i].tMax == 0) == (strength == 0));
        }
        CHECK(parted <= 20);
    }
}

TEST_CASE("aimed photons carry the flux that the light sends towards the targets") {
    // A point light of 1 W/sr at the distance 2 from a ball of radius 0.5, and from another that overlaps it: the flux
    // through the union of the two cones is what the share of unaimed photons through it says. One cone alone holds
    // 2 pi (1 - cos a) with sin a = 1/4: 0.19946 sr.
    Scene scene;
    const std::size_t glass = reference::test::addMaterial(scene, Dielectric{1.5});
    scene.lights = {{{0, 0, 0}, dvec3(1)}};
    reference::test::addObject(scene, Sphere{{2, 0, 0}, 0.5}, glass);
    const std::uint32_t count = 40000;
    const auto fluxOf = [&](const Emitted& emitted) {
        double flux = 0;
        for (const shared::PhotonPath& path : emitted.paths) {
            flux += meanOf(path.power);
        }
        return flux;
    };
    {
        BothSides both(scene);
        const double cone = 2 * std::numbers::pi * (1 - std::sqrt(1 - 1.0 / 16));
        CHECK(std::abs(fluxOf(emitCausticPhotons(both, causticPass(count))) / cone - 1) < 1e-4); // margin of 2e-5 twice
    }
    reference::test::addObject(scene, Sphere{{2, 0.4, 0.1}, 0.6}, glass);
    BothSides both(scene);
    const Emitted emitted = emitCausticPhotons(both, causticPass(count));
    // By an even grid of directions: longitude and the sine of latitude
    std::size_t inside = 0;
    const int grid = 2000;
    for (int i = 0; i < grid; ++i) {
        for (int j = 0; j < grid; ++j) {
            const double z = 2 * (i + 0.5) / grid - 1;
            const double phi = 2 * std::numbers::pi * (j + 0.5) / grid;
            const double s = std::sqrt(1 - z * z);
            const dvec3 direction(s * std::cos(phi), s * std::sin(phi), z);
            const auto meets = [&](const dvec3& center, double radius) {
                return glm::dot(direction, center) > 0 && glm::length(glm::cross(direction, center)) < radius;
            };
            inside += meets({2, 0, 0}, 0.5) || meets({2, 0.4, 0.1}, 0.6) ? 1 : 0;
        }
    }
    const double expected = 4 * std::numbers::pi * static_cast<double>(inside) / (double{grid} * grid);
    // Weights are 1 or 1/2 of the same size: a standard deviation below 1/2 / sqrt(40 000) = 0.25 %; five of them
    CHECK(std::abs(fluxOf(emitted) / expected - 1) < 0.0125);
    // Where cones overlap a photon carries half
    std::vector<double> powers;
    for (const shared::PhotonPath& path : emitted.paths) {
        powers.push_back(meanOf(path.power));
    }
    const auto [low, high] = std::ranges::minmax(powers);
    CHECK(std::abs(low / high - 0.5) < 1e-3);
}

TEST_CASE("shadow photons fall where the reference's fall") {
    Scene scene = litBox();
    scene.render.photons = 3000;
    BothSides both(scene);
    render::ShadowPhotonPaths paths(both.device, both.scene, both.deviceScene, scene.render.photons);
    const std::uint32_t slots = paths.cast(scene.render.photons);
    both.device.commands.finish();
    const std::vector<shared::Photon> photons = render::storedPhotons(paths.photons(), slots);
    std::vector<reference::Photon> expected = reference::castShadowPhotons(both.world, 0);
    // The device lists them hit by hit
    std::ranges::stable_sort(expected, {}, &reference::Photon::depth);
    CHECK(std::abs(double(photons.size()) - double(expected.size())) <= 3); // a path past an edge
    std::size_t direct = 0;
    std::size_t alike = 0;
    for (std::size_t i = 0; i < std::min(photons.size(), expected.size()); ++i) {
        const bool same = distance(photons[i].position, expected[i].position) < 1e-4;
        alike += same ? 1 : 0;
        if (same) {
            CHECK(((photons[i].surface >> shared::kKindShift) & 3U) == static_cast<std::uint32_t>(expected[i].kind));
            CHECK(photons[i].surface >> shared::kLengthShift == expected[i].light);
            CHECK(photons[i].power == vec3(0));
            direct += expected[i].kind == reference::PhotonKind::Direct ? 1 : 0;
        }
    }
    CHECK(100 * alike >= 99 * expected.size());
    CHECK(direct > 1000);
    CHECK(alike - direct > 200); // behind the spheres and the lamps
}

// Sorted by every bit, since pieces are listed one after the other.
std::vector<std::array<std::uint32_t, 8>> sortedBits(const gpu::Array<shared::Photon>& photons, std::uint32_t slots) {
    std::vector<std::array<std::uint32_t, 8>> bits;
    for (const shared::Photon& photon : render::storedPhotons(photons, slots)) {
        bits.push_back(std::bit_cast<std::array<std::uint32_t, 8>>(photon));
    }
    std::ranges::sort(bits);
    return bits;
}

TEST_CASE("photons traced in pieces are, bit for bit, those traced at once, and so is the account of their flux") {
    const Scene scene = litBox();
    const std::uint32_t count = 3000;
    const std::uint32_t sequence =
        shared::photonSequence(shared::renderSeed(1, shared::kSobolNumbers), shared::kGlobalPhotons, 0);
    const std::uint32_t direct = 1U << shared::kPhotonDirect;
    const std::uint32_t others = 1U << shared::kPhotonIndirect | 1U << shared::kPhotonCaustic;
    for (const auto& [kinds, aimed] : {std::pair{direct | others, false}, {others, false}, {others, true}}) {
        CAPTURE(kinds, aimed);
        const auto trace = [&, wanted = kinds, towards = aimed](std::uint32_t atOnce) {
            BothSides both(scene);
            render::PhotonPaths paths(both.device, both.scene, both.deviceScene, atOnce);
            const std::uint32_t slots =
                paths.trace({.sequence = sequence, .count = count, .kinds = wanted, .aimed = towards, .account = true});
            both.device.commands.finish();
            dvec3 emitted(0), stored(0);
            for (const render::LightBalance& light : paths.balance()) {
                emitted += light.emitted;
                stored += light.stored;
            }
            return std::tuple(sortedBits(paths.photons(), slots), emitted, stored, paths.raysTraced());
        };
        const auto atOnce = trace(count);
        CHECK(std::get<0>(atOnce).size() > 500);
        for (const std::uint32_t piece : {1000U, 1234U}) { // with and without a smaller last piece
            const auto pieces = trace(piece);
            CHECK((pieces == atOnce));
        }
    }
}

TEST_CASE("shadow photons cast in pieces are those cast at once") {
    BothSides both(litBox());
    render::ShadowPhotonPaths whole(both.device, both.scene, both.deviceScene, 2000);
    render::ShadowPhotonPaths parts(both.device, both.scene, both.deviceScene, 700);
    const std::uint32_t slotsOfWhole = whole.cast(2000);
    const std::uint32_t slotsOfParts = parts.cast(2000);
    both.device.commands.finish();
    CHECK((sortedBits(parts.photons(), slotsOfParts) == sortedBits(whole.photons(), slotsOfWhole)));
    CHECK(slotsOfParts == slotsOfWhole);
}

TEST_CASE("a gathering ray leaves with the numbers and the weight of the reference's, never into the surface") {
    BothSides both(withPaints(reference::test::cornellBox()));
    reference::test::Random random;
    const std::uint32_t count = 5000;
    const std::uint32_t pass = shared::gatherPass(12, 3, 1);
    std::vector<shared::VisiblePoint> points(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        points[i] = PointMade{.position = random.inCube(1),
                              .depth = i % 3,
                              .normal = random.direction(),
                              .samplerSeed = shared::hash(i),
                              .beta = vec3(0.3, 0.2, 0.1),
                              .pixel = i,
                              .from = 5,
                              .material = paintOf(both.scene, i % 2 == 0)};
    }
    const auto devicePoints = both.upload(points);
    const auto rays = both.room<shared::Ray>(count);
    const auto paths = both.room<shared::CameraPath>(count);
    const auto alive = both.room<shared::uint>(count);
    both.run(
        "start_gather_rays",
        shared::StartGatherRaysArguments{devicePoints, both.deviceScene.materials, rays, paths, alive, count, pass},
        count);
    std::size_t started = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const shared::Sampler sampler = shared::pathSampler(shared::gatherSequence(points[i].samplerSeed), pass);
        const dvec3 direction = reference::cosineHemisphere(
            reference::sampleUnitSquare(sampler, shared::kGatherDirection), dvec3(points[i].normal));
        if (std::abs(direction.z) < 1e-4) {
            continue; // on the horizon either side may say no
        }
        REQUIRE((alive.host()[i] == 1) == (points[i].depth > 0 && direction.z > 0));
        if (alive.host()[i] == 1) {
            ++started;
            CHECK(distance(rays.host()[i].direction, direction) < 2e-6);
            CHECK(rays.host()[i].from == 5);
            const double cosine = glm::dot(direction, dvec3(points[i].normal));
            // f cos / (cos / pi) of white paint is beta; under a coat of F0 = 0.04, 21/20 (1 - F0) of it enters and
            // leaves
            const double coated = 21.0 / 20 * 0.96 * reference::coatTransmission(cosine);
            CHECK(distance(paths.host()[i].beta, dvec3(points[i].beta) * (i % 2 == 0 ? coated : 1.0)) < 1e-5);
            CHECK(paths.host()[i].pixel == i);
        }
    }
    CHECK(started > count / 4);
}

TEST_CASE("known visibility spares shadow rays: lit places get the light, hidden ones none") {
    BothSides both(reference::test::cornellBox());
    const std::uint32_t count = 300;
    std::vector<shared::uint> lit(count);
    std::vector<shared::uint> shadowed(count);
    std::vector<shared::Ray> rays(count, {vec3(0), 1, vec3(0, 0, 1), 0});
    for (std::uint32_t i = 0; i < count; ++i) {
        lit[i] = i % 3 == 0 ? 1U << 2U : 1U; // light 2, or another
        shadowed[i] = i % 3 == 1 ? 1U << 2U : 1U << 4U;
        rays[i].tMax = i < 30 ? 0.0F : 1.0F; // nothing to trace
    }
    const auto deviceRays = both.upload(rays);
    const auto direct = both.upload(std::vector<vec3>(count, vec3(1)));
    const render::DeviceCounter saved(both.device.context, "saved");
    both.run("skip_shadow_rays",
             shared::SkipShadowRaysArguments{both.upload(lit), both.upload(shadowed), deviceRays,
                                             both.upload(std::vector<vec3>(count, vec3(2))), direct, saved, 2, count},
             count);
    CHECK(saved.read() == 180);
    for (std::uint32_t i = 30; i < count; ++i) {
        CHECK(direct.host()[i] == (i % 3 == 0 ? vec3(3) : vec3(1)));
        CHECK((deviceRays.host()[i].tMax > 0) == (i % 3 == 2));
    }
    CHECK(direct.host()[0] == vec3(1));
}

} // namespace hyalite::testing
