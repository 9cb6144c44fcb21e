// White furnace tests: under radiance 1 from all directions, objects without absorption are invisible, and absorbing
// ones show their albedo.
#include "image/known_answer.h"
#include "kernel/kernel_support.h"
#include "unit/reference/furnace.h"

#include <complex>
#include <numbers>

namespace hyalite::testing {

namespace {

using glm::dvec3;
using std::numbers::pi;

constexpr std::string_view kWithIndirectLight[] = {"ppm", "photonmap", "path"};

// A closed cube of 2 m about the origin whose walls have radiance 1 and the albedo; the camera at its centre looks at
// the central 0.27 m of a wall: farther from the edges than the search radius.
Scene furnace(double albedo) {
    Scene scene = reference::test::onePixel({0, 0, 0}, {0, 0, 1}, "path");
    scene.camera.fov = 30;
    scene.camera.resolution = {8, 8};
    scene.render.maxDepth = 64;
    scene.render.photons = 20000;
    scene.render.radius = 0.3;
    scene.render.photonMap.gatherRays = 0;
    scene.render.photonMap.nearest = 512;
    reference::test::addFurnace(scene, albedo);
    return scene;
}

// A sky of radiance 1 and a pixel that sees a single point, at `angle` from its normal (+y).
Scene underSky(double angle) {
    Scene scene = reference::test::onePixel({3 * std::sin(angle), 3 * std::cos(angle), 0}, {0, 0, 0}, "path");
    scene.camera.resolution = {16, 16};
    scene.environment = Environment{.image = Image(1, 1)};
    scene.environment->image.at(0, 0) = glm::vec3(1);
    scene.render.minWeight = 0;
    return scene;
}

} // namespace

TEST_CASE("in a closed furnace radiance is 1 / (1 - a), or its truncated series for short paths") {
    // The walls emit 1 and reflect what arrives from all directions: 1 + a + a^2 + …; n segments give n terms
    const std::vector<Renderer> renderers = renderersOf(kWithIndirectLight);
    const std::vector<std::pair<double, std::uint32_t>> cases{{0.2, 64}, {0.5, 4}, {0.8, 64}};
    FalseAlarms alarms(renderers.size() * cases.size());
    for (const auto& [albedo, depth] : cases) {
        for (const Renderer& renderer : renderers) {
            Scene scene = furnace(albedo);
            scene.render.maxDepth = depth;
            scene.render.passes = renderer.integrator == "path" ? 128 : 4;
            INFO(renderer.name << ", albedo " << albedo << ", depth " << depth);
            const double expected = (1 - std::pow(albedo, depth)) / (1 - albedo);
            CHECK(judge(alarms, renderer, scene, everywhere(expected), Independent::Renders,
                        {.bias = 1e-5, .sees = 0.2}));
        }
    }
}

TEST_CASE("whitted's furnace has the emission and the direct light of its walls, 1 + a") {
    const std::string_view whitted[] = {"whitted"};
    const std::vector<Renderer> renderers = renderersOf(whitted);
    FalseAlarms alarms(renderers.size());
    for (const Renderer& renderer : renderers) {
        Scene scene = furnace(0.5);
        scene.render.passes = 32;
        INFO(renderer.name);
        CHECK(judge(alarms, renderer, scene, everywhere(1.5), Independent::Pixels, {.bias = 1e-5, .sees = 0.02}));
    }
}

TEST_CASE("a perfect mirror and clear glass are indistinguishable from the walls of a furnace") {
    // Radiance is the same along every line, and they absorb none of it. In a path of 64 segments, 32 diffuse ones
    // truncate a^32 of the light, and a ray stays in glass for more than 32 with probability 0.04^32. The furnace is
    // almost a sphere, whose points illuminate each other equally, so samples of its light have no tail.
    const std::string_view path[] = {"path"};
    const std::vector<Renderer> renderers = renderersOf(path);
    FalseAlarms alarms(2 * renderers.size());
    for (const MaterialModel& model : {MaterialModel(Mirror{}), MaterialModel(Dielectric{1.5})}) {
        Scene scene = furnace(0.5);
        scene.camera.fov = 60;
        scene.meshes = {sphereMesh(12, false)};
        for (glm::uvec3& triangle : scene.meshes[0].triangles) {
            std::swap(triangle.y, triangle.z); // faces inwards
        }
        scene.objects = {{.shape = MeshInstance{}, .material = 0, .emission = dvec3(1), .where = {}}};
        reference::test::addObject(scene, Sphere{{0.1, 0, 0.5}, 0.3}, reference::test::addMaterial(scene, model));
        scene.render.passes = 256;
        for (const Renderer& renderer : renderers) {
            INFO(renderer.name << ", material " << model.type);
            CHECK(judge(alarms, renderer, scene, everywhere(2), Independent::Pixels, {.bias = 1e-5, .sees = 0.05}));
        }
    }
}

namespace {

// Schlick's reflectance of a metal whose colour is `f0`.
std::function<double(double)> schlick(double f0) {
    return [f0](double cosine) { return f0 + (1 - f0) * std::pow(1 - cosine, 5); };
}

// Fresnel reflectance for the index eta + i k: amplitudes with a complex cosine.
std::function<double(double)> fresnel(double eta, double k) {
    return [n = std::complex<double>(eta, k)](double cosine) {
        const std::complex<double> inside = std::sqrt(1.0 - (1 - cosine * cosine) / (n * n));
        const double s = std::norm((cosine - n * inside) / (cosine + n * inside));
        const double p = std::norm((n * cosine - inside) / (n * cosine + inside));
        return (s + p) / 2;
    };
}

// Reflectance of a GGX surface under a sky of radiance 1, in a direction at `angle` to its normal, from the facets
// visible there: the integral of F(w . m) D(m) (w . m)+ / w.z times the fraction of reflected light that is not masked,
// which is G2 / G1 (w) with Lambda = (sqrt(1 + a^2 tan^2) - 1) / 2, G1 = 1 / (1 + Lambda), G2 = 1 / (1 + Lambda +
// Lambda') [Heitz14], [Walter07]; G1 G2 / G1 = G2. Midpoints in the facet's tangent, as u = 1 / (1 + tan^2 / a^2), in
// which D is uniform, and in the azimuth.
double ggxAlbedo(double angle, double alpha, const std::function<double(double)>& reflectance) {
    const dvec3 w(std::sin(angle), 0, std::cos(angle));
    const auto lambda = [alpha](const dvec3& v) {
        const double tan2 = (v.x * v.x + v.y * v.y) / (v.z * v.z);
        return (std::sqrt(1 + alpha * alpha * tan2) - 1) / 2;
    };
    constexpr int kSteps = 1000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double u = (i + 0.5) / kSteps; // D cos dm = du dphi / (2 pi)
        const double tangent = alpha * std::sqrt((1 - u) / u);
        const double cosine = 1 / std::sqrt(1 + tangent * tangent);
        for (int j = 0; j < kSteps; ++j) {
            const double phi = 2 * pi * (j + 0.5) / kSteps;
            const dvec3 m = cosine * dvec3(tangent * std::cos(phi), tangent * std::sin(phi), 1);
            const double facing = glm::dot(w, m);
            const dvec3 out = 2 * facing * m - w;
            if (facing > 0 && out.z > 0) {
                sum += reflectance(facing) * facing / (w.z * m.z) / (1 + lambda(w) + lambda(out));
            }
        }
    }
    return sum / (kSteps * kSteps);
}

} // namespace

TEST_CASE("under a sky of radiance 1 a rough metal shows its facets' albedo, whichever strategy finds the light") {
    // Sampled lights and rays that hit the sky are combined by MIS weights: a wrong weight would show
    struct Metal {
        MaterialModel model;
        double angle;
        double alpha;
        std::function<double(double)> reflectance;
    };
    const std::vector<Metal> metals{
        {MetallicRoughness{dvec3(0.3), 1, 0.8}, pi / 4, 0.64, schlick(0.3)},
        {Conductor{dvec3(0.2), dvec3(3.9), 0.5}, pi / 3, 0.25, fresnel(0.2, 3.9)},
        {Conductor{dvec3(1.5), dvec3(0.5), 1}, pi / 4, 1, fresnel(1.5, 0.5)},
    };
    CHECK(std::abs(ggxAlbedo(0, 0.09, schlick(1)) - 0.99) < 0.005); // as the documentation says: 1 % is lost,
    CHECK(std::abs(ggxAlbedo(0, 1, schlick(1)) - 0.31) < 0.005);    // and 69 % at roughness 1
    FalseAlarms alarms(metals.size() * everyRenderer().size());
    for (const Metal& metal : metals) {
        const double expected = ggxAlbedo(metal.angle, metal.alpha, metal.reflectance);
        Scene scene = underSky(metal.angle);
        const std::size_t material = reference::test::addMaterial(scene, metal.model);
        reference::test::addObject(scene, Disk{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}, material); // faces up
        scene.render.passes = 16;
        for (const Renderer& renderer : everyRenderer()) {
            INFO(renderer.name << ", material " << metal.model.type << " at " << metal.angle);
            // The midpoint rule is accurate to 1e-5 here; the pixel spans angles of 1e-4
            CHECK(judge(alarms, renderer, scene, everywhere(expected), Independent::Pixels,
                        {.bias = 2e-4, .sees = 0.05}));
        }
    }
}

} // namespace hyalite::testing
