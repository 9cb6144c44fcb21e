// Spots, parallel light and emitting meshes against closed forms: direct light on a surface, and photons.
#include "reference/lights/lights.h"
#include "reference/photons/photons.h"

#include "reference/world.h"
#include "unit/reference/support.h"

#include <cmath>
#include <numbers>

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

using std::numbers::pi;

// A point with f = albedo / pi for albedo 1.
VisiblePoint whitePoint(const dvec3& position, const dvec3& normal) {
    return {.position = position,
            .shadowOrigin = position,
            .normal = normal,
            .geometricNormal = normal,
            .wo = normal,
            .beta = dvec3(1),
            .material = Diffuse{dvec3(1)},
            .depth = 1,
            .samplerSeed = 8}; // even: Sobol points
}

// Irradiance from the only light.
dvec3 irradiance(const Scene& scene, const dvec3& position, const dvec3& normal) {
    const auto sample = sampleLight(prepareWorld(scene), whitePoint(position, normal), 0, 0);
    return sample ? sample->contribution * pi : dvec3(0);
}

// Flux of the photons of the scene, `count` of them, that land on its first object before all others.
dvec3 fluxOnFirst(const Scene& original, std::uint32_t count) {
    Scene scene = original;
    scene.render.photons = count;
    const World world = prepareWorld(scene);
    const PhotonPass pass = progressivePass(world, 0);
    dvec3 flux(0);
    for (std::uint32_t photon = 0; photon < count; ++photon) {
        const Emission emission = emitPhoton(world, photon, pass);
        const auto hit = traceClosest(world, emission.ray);
        if (hit && hit->object == 0) {
            flux += emission.power;
        }
    }
    return flux;
}

Scene spotDown() {
    Scene scene;
    scene.spots = {{.position = {0, 2, 0}, .direction = {0, -1, 0}, .intensity = {1, 2, 3}, .angle = 40, .blend = 0.5}};
    return scene;
}

// Unit square in z = 0 facing +z, cut along its diagonal.
Mesh squareMesh() {
    return {.file = {},
            .positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
            .normals = {},
            .triangles = {{0, 1, 2}, {0, 2, 3}},
            .uvs = {}};
}

} // namespace

TEST_CASE("a spot lights a floor by I cos / d^2 within its cone and falls off smoothly to zero at its edge") {
    const Scene scene = spotDown();
    const auto at = [&](double degrees) { // on the floor, that far from the axis; d = 2 / cos
        const double angle = degrees * pi / 180;
        return irradiance(scene, {2 * std::tan(angle), 0, 0}, {0, 1, 0}) / (std::pow(std::cos(angle), 3) / 4);
    };
    checkNear(at(0), {1, 2, 3}, 1e-12);
    checkNear(at(19.9), {1, 2, 3}, 1e-12); // full up to (1 - blend) 40 degrees
    CHECK(at(40.1) == dvec3(0));
    // Where the cosine is half way between those of 20 and 40 degrees, 3/4 - 2/8 = 1/2
    const double half = std::acos((std::cos(20 * pi / 180) + std::cos(40 * pi / 180)) / 2) * 180 / pi;
    checkNear(at(half), {0.5, 1, 1.5}, 1e-12);
    // Both ends are level: 3 t^2 at t = d / 0.1737 for d = 1e-4 off in the cosine
    CHECK(at(39.99).x < 1e-6 * 3);
    CHECK(at(20.01).x > 1 - 1e-6 * 3);
}

TEST_CASE("the power of a spot is pi (2 - cos inner - cos outer) I, that of a point at 180 degrees without a blend") {
    Scene scene = spotDown();
    const double sum = 2 - std::cos(20 * pi / 180) - std::cos(40 * pi / 180);
    checkNear(makeLights(scene).at(0).power, pi * sum * dvec3(1, 2, 3), 1e-12);
    scene.spots[0].angle = 180;
    scene.spots[0].blend = 0;
    checkNear(makeLights(scene).at(0).power, 4 * pi * dvec3(1, 2, 3), 1e-12);
}

TEST_CASE("photons leave a spot in proportion to its intensity") {
    const World world = prepareWorld(spotDown());
    const Light& light = world.lights.at(0);
    // The mean cosine with the axis is the integral of c s(c) over that of s(c). With a = cos 20, b = cos 40, w = a -
    // b: the first is (1 - a^2) / 2 + w (b / 2 + 7/20 w), for the integral of t^3 (3 - 2 t) is 3/4 - 2/5 = 7/20
    const double a = std::cos(20 * pi / 180);
    const double b = std::cos(40 * pi / 180);
    const double w = a - b;
    const double expected = ((1 - a * a) / 2 + w * (b / 2 + 0.35 * w)) / ((1 - a) + w / 2);
    Random random;
    constexpr int kCount = 20000;
    double sum = 0;
    for (int i = 0; i < kCount; ++i) {
        const LightRay ray = emitFrom(light, {0, 0}, {random.unit(), random.unit()});
        CHECK(ray.origin == dvec3(0, 2, 0));
        CHECK_THAT(glm::length(ray.direction), WithinAbs(1, 1e-12));
        // Density times power is the intensity that way
        checkNear(ray.pdfDirection * ray.power, irradiance(spotDown(), ray.origin + ray.direction, -ray.direction),
                  1e-9);
        sum += -ray.direction.y;
    }
    // Cosines lie in [0.77, 1]: their deviation is at most 0.12, five standard errors 5 * 0.12 / sqrt(20000)
    CHECK_THAT(sum / kCount, WithinAbs(expected, 0.0042));
}

TEST_CASE("directional light gives a surface E cos, however far it is") {
    Scene scene;
    scene.directionals = {{.direction = {0.6, -0.8, 0}, .irradiance = {1, 2, 3}}};
    addObject(scene, Sphere{{0, 0, 0}, 1}, std::nullopt);
    checkNear(irradiance(scene, {0, 0, 0}, {0, 1, 0}), 0.8 * dvec3(1, 2, 3), 1e-12);
    checkNear(irradiance(scene, {500, 0, 3}, {0, 1, 0}), 0.8 * dvec3(1, 2, 3), 1e-12);
    CHECK(irradiance(scene, {0, 0, 0}, {0, -1, 0}) == dvec3(0));
    // The shadow ray has no end: a wall a million metres off blocks it
    const World open = prepareWorld(scene);
    const auto sample = sampleLight(open, whitePoint({0, 5, 0}, {0, 1, 0}), 0, 0);
    REQUIRE(sample);
    CHECK(traceShadow(open, sample->from, sample->to));
    addObject(scene, Plane{{0, 1e6, 0}, {0, -1, 0}}, std::nullopt);
    CHECK_FALSE(traceShadow(prepareWorld(scene), sample->from, sample->to));
}

TEST_CASE("a beam lights its cylinder, from its disc on, and has the power E pi r^2") {
    Scene scene;
    scene.directionals = {
        {.direction = {0, -1, 0}, .irradiance = dvec3(5), .beam = DirectionalLight::Beam{{1, 3, 0}, 0.5}}};
    checkNear(makeLights(scene).at(0).power, dvec3(5 * pi / 4), 1e-12);
    checkNear(irradiance(scene, {1.49, 0, 0}, {0, 1, 0}), dvec3(5), 1e-12);
    CHECK(irradiance(scene, {1.51, 0, 0}, {0, 1, 0}) == dvec3(0));
    CHECK(irradiance(scene, {1, 3.1, 0}, {0, 1, 0}) == dvec3(0)); // behind the disc
    // Every photon lands on a floor that the beam falls on
    addObject(scene, Quad{{0, 0, 1}, {2, 0, 0}, {0, 0, -2}}, std::nullopt);
    checkNear(fluxOnFirst(scene, 256), dvec3(5 * pi / 4), 1e-12);
}

TEST_CASE("photons carry to a surface the flux of its irradiance") {
    constexpr std::uint32_t kCount = 65536;
    // Within five standard errors of independent photons, of which the surface has the share p: 5 sqrt((1 - p) / (p n))
    const auto check = [&](const Scene& scene, const dvec3& expected) {
        const double p = expected.x / makeLights(scene).at(0).power.x;
        checkNear(fluxOnFirst(scene, kCount), expected, 5 * std::sqrt((1 - p) / (p * kCount)) * glm::length(expected));
    };
    const Quad square{{-0.5, 0, 0.5}, {1, 0, 0}, {0, 0, -1}}; // faces +y
    SECTION("parallel light: E A cos") {
        Scene scene;
        scene.directionals = {{.direction = {0.6, -0.8, 0}, .irradiance = {1, 2, 3}}};
        addObject(scene, square, std::nullopt);
        check(scene, 0.8 * dvec3(1, 2, 3));
        addObject(scene, Sphere{{2, 1, 0}, 0.5}, std::nullopt); // a larger scene: fewer photons for the square
        check(scene, 0.8 * dvec3(1, 2, 3));
        addObject(scene, Plane{{0, -1, 0}, {0, 1, 0}}, std::nullopt); // from farther off
        check(scene, 0.8 * dvec3(1, 2, 3));
    }
    SECTION("a constant environment: pi L A on each side") {
        Scene scene;
        scene.environment = Environment{.image = Image(1, 1), .scale = 2};
        scene.environment->image.at(0, 0) = dvec3(1, 2, 3);
        addObject(scene, square, std::nullopt);
        check(scene, 4 * pi * dvec3(1, 2, 3));
    }
    SECTION("an emitting mesh inside a sphere: all of it") {
        Scene scene;
        addObject(scene, Sphere{{0, 0, 0}, 5}, std::nullopt);
        scene.meshes = {squareMesh()};
        addObject(scene, MeshInstance{0, glm::dmat4(1)}, std::nullopt, {1, 2, 3});
        checkNear(fluxOnFirst(scene, kCount), pi * dvec3(1, 2, 3), 1e-9);
    }
}

TEST_CASE("a mesh of two triangles emits like the same quad") {
    Scene mesh;
    mesh.meshes = {squareMesh()};
    // Stretched, sheared, turned over and moved
    const glm::dmat4 place(2, 0, 0.5, 0, 0.3, -1.5, 0, 0, 0, 0.2, 1, 0, -1, 2, 3, 1);
    addObject(mesh, MeshInstance{0, place}, std::nullopt, {1, 2, 3});
    Scene quad;
    // The determinant is negative: a mirror image keeps its front where the mirror puts it, so the edges change places
    addObject(quad, Quad{dvec3(place[3]), dvec3(place[1]), dvec3(place[0])}, std::nullopt, {1, 2, 3});
    if (glm::determinant(glm::dmat3(place)) > 0) {
        FAIL("the test wants a mirror image");
    }
    const World asMesh = prepareWorld(mesh);
    const World asQuad = prepareWorld(quad);
    checkNear(asMesh.lights.at(0).power, asQuad.lights.at(0).power, 1e-12);
    const auto mean = [](const World& world, const VisiblePoint& x) {
        constexpr std::uint32_t kPasses = 4096;
        dvec3 sum(0);
        for (std::uint32_t pass = 0; pass < kPasses; ++pass) {
            const auto sample = sampleLight(world, x, shared::kCameraSequences * pass, 0);
            sum += sample ? sample->contribution : dvec3(0);
        }
        return sum / double(kPasses);
    };
    const dvec3 center = dvec3(place * glm::dvec4(0.5, 0.5, 0, 1));
    const dvec3 front = glm::normalize(glm::cross(dvec3(place[1]), dvec3(place[0]))); // of the quad, and so of the mesh
    const VisiblePoint before = whitePoint(center + 2.0 * front, -front);
    const VisiblePoint behind = whitePoint(center - 2.0 * front, front);
    // Samples vary by a factor of about two: independent, 4096 of them are right to 0.5 %, five times that
    const dvec3 expected = mean(asQuad, before);
    CHECK(expected.x > 0.1);
    checkNear(mean(asMesh, before), expected, 0.025 * glm::length(expected));
    CHECK(mean(asMesh, behind) == dvec3(0));
    CHECK(mean(asQuad, behind) == dvec3(0));
}

TEST_CASE("points are spread over a mesh by area") {
    Scene scene;
    scene.meshes = {squareMesh()};
    scene.meshes[0].positions[3] = {-2, 3, 0}; // the second triangle: half of |(1, 1) x (-2, 3)| = 5/2, the first 1/2
    addObject(scene, MeshInstance{0, glm::dmat4(1)}, std::nullopt, {1, 1, 1});
    const std::vector<Light> lights = makeLights(scene);
    checkNear(lights.at(0).power, dvec3(3 * pi), 1e-12);
    Random random;
    constexpr int kCount = 20000;
    int first = 0;
    dvec3 sum(0);
    for (int i = 0; i < kCount; ++i) {
        const LightRay ray = emitFrom(lights[0], {random.unit(), random.unit()}, {0.3, 0.7});
        CHECK(ray.normal == dvec3(0, 0, 1));
        first += ray.origin.y < ray.origin.x ? 1 : 0;
        sum += ray.origin;
    }
    // Five standard errors of a share of 1/6
    CHECK_THAT(first / double(kCount), WithinAbs(1.0 / 6, 5 * std::sqrt(5.0 / 36 / kCount)));
    // Centroids (2/3, 1/3) and (-1/3, 4/3), in the proportion of 1 to 5; coordinates deviate by less than 1
    checkNear(sum / double(kCount), (dvec3(2, 1, 0) / 3.0 + 5.0 * dvec3(-1, 4, 0) / 3.0) / 6.0,
              5 / std::sqrt(double(kCount)));
}

TEST_CASE("a photon share of two counts twice in both halves of a light's probability") {
    Scene scene;
    scene.lights = {{.position = {0, 1, 0}, .intensity = dvec3(1)},
                    {.position = {0, 2, 0}, .intensity = dvec3(2), .photonShare = 2}};
    const std::vector<Light> lights = makeLights(scene);
    // Half by flux, 1 to 2 * 2, and half even, 1 to 2
    CHECK_THAT(lights.at(0).pmf, WithinAbs((1.0 / 5 + 1.0 / 3) / 2, 1e-15));
    CHECK_THAT(lights.at(1).pmf, WithinAbs((4.0 / 5 + 2.0 / 3) / 2, 1e-15));
    checkNear(lights.at(1).power, dvec3(8 * pi), 1e-12);
    scene.render.photons = 1000;
    const World world = prepareWorld(scene);
    dvec3 sum(0);
    for (std::uint32_t photon = 0; photon < 1000; ++photon) {
        sum += emitPhoton(world, photon, progressivePass(world, 0)).power;
    }
    checkNear(sum, dvec3(12 * pi), 0.01 * 12 * pi); // stratified: one photon of a light more or less
}

TEST_CASE("the density of a direction to a light is that of the point times d^2 / cos") {
    Scene scene;
    addObject(scene, Quad{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}, std::nullopt, dvec3(1));
    addObject(scene, Sphere{{0, 0, 0}, 0.5}, std::nullopt, dvec3(1));
    scene.lights = {{.position = {0, 0, 0}, .intensity = dvec3(1)}};
    const std::vector<Light> lights = makeLights(scene);
    const dvec3 receiver(0, 0, 4);
    // 16 / (0.8 * 6), and of the facing half of the sphere: 16 / (1 * pi / 2)
    CHECK_THAT(lightPdf(lights.at(1), receiver, {0.6, 0, -0.8}, 4, {0, 0, 1}), WithinRel(16 / 4.8, 1e-12));
    CHECK_THAT(lightPdf(lights.at(2), receiver, {0, 0, -1}, 4, {0, 0, 1}), WithinRel(32 / pi, 1e-12));
    CHECK(lightPdf(lights.at(1), receiver, {0, 0, 1}, 4, {0, 0, 1}) == 0); // from behind
    CHECK(lightPdf(lights.at(0), receiver, {0, 0, -1}, 4, {0, 0, 0}) == 0);
}

TEST_CASE("a light's density times power is its emission") {
    // Radiance of a ray: power * density of the direction / area = L cos; intensity of a point: power * density
    Scene scene;
    scene.lights = {{.position = {0, 0, 0}, .intensity = dvec3(3)}};
    scene.directionals = {
        {.direction = {0, 0, -1}, .irradiance = dvec3(5), .beam = DirectionalLight::Beam{{0, 0, 0}, 0.5}}};
    addObject(scene, Quad{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}, std::nullopt, dvec3(7));
    const std::vector<Light> lights = makeLights(scene);
    const LightRay point = emitFrom(lights.at(0), {0.1, 0.2}, {0.3, 0.4});
    checkNear(point.power * point.pdfDirection, dvec3(3), 1e-12);
    const LightRay beam = emitFrom(lights.at(1), {0.1, 0.2}, {0.3, 0.4});
    checkNear(beam.power * beam.pdfOrigin, dvec3(5), 1e-12);
    CHECK(beam.pdfDirection == 0);
    CHECK(originDensity(lights.at(1), beam.origin + dvec3(0, 0, -4), beam.direction) == beam.pdfOrigin);
    CHECK(originDensity(lights.at(1), {0.6, 0, 0}, beam.direction) == 0);
    const LightRay quad = emitFrom(lights.at(2), {0.1, 0.2}, {0.3, 0.4});
    checkNear(quad.power * quad.pdfDirection / 6.0, dvec3(7) * quad.direction.z, 1e-12);
    CHECK(emissionDensity(lights.at(2), {0, 0, 1}, {0, 0, -1}) == 0);
}
