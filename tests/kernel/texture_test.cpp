// Textures on every shape that has coordinates, on the device against the reference.
#include "kernel/bounce.h"
#include "kernel/visible_points.h"
#include "reference/integrators/shading.h"

#include <glm/gtc/matrix_transform.hpp>

namespace hyalite::testing {

namespace {

Image noise(int width, int height) {
    reference::test::Random random;
    Image image(width, height);
    for (vec3& pixel : image.pixels) {
        pixel = vec3(random.unit(), random.unit(), random.unit());
    }
    return image;
}

// A room of textured quads, with spheres, a disk, two meshes, a mirror and a solid in it.
Scene texturedRoom() {
    Scene scene = reference::test::cornellBox();
    scene.objects.resize(6);
    scene.textures = {{"noise", ImageTexture{std::make_shared<const Image>(noise(7, 5))}},
                      {"world", Checker{.colors = {dvec3(0.1, 0.2, 0.3), dvec3(0.9, 0.8, 0.7)}, .size = 0.2}},
                      {"uv", Checker{.colors = {dvec3(0), dvec3(1)}, .size = 0.125, .inWorld = false}},
                      {"dots", ImageTexture{std::make_shared<const Image>(noise(64, 32))}}};
    std::vector<std::size_t> textured;
    for (std::size_t texture = 0; texture < scene.textures.size(); ++texture) {
        textured.push_back(reference::test::addMaterial(scene, Diffuse{{1, 0.5, 0.75}}));
        scene.materials.back().colorTexture = texture;
    }
    const std::size_t mirror = reference::test::addMaterial(scene, Mirror{});
    scene.materials[mirror].colorTexture = 0;
    for (std::size_t wall = 0; wall < 5; ++wall) {
        scene.objects[wall].material = textured[wall % 4];
    }
    const std::size_t worn = reference::test::addMaterial(scene, MetallicRoughness{dvec3(1), 1, 1});
    scene.materials[worn].colorTexture = 0;
    scene.materials[worn].roughnessTexture = 3;
    Mesh mesh = sphereMesh(6, true);
    for (const vec3& p : mesh.positions) {
        mesh.uvs.emplace_back(2 * p.x, p.y - 3 * p.z); // beyond the unit square, either way
    }
    scene.meshes = {mesh, sphereMesh(4, false)}; // the second has no coordinates, and needs none in the world
    const auto place = [](const dvec3& at, double size) {
        return glm::scale(glm::translate(glm::dmat4(1), at), dvec3(size));
    };
    reference::test::addObject(scene, MeshInstance{1, place({-0.6, 0.5, -0.5}, 0.3)}, textured[1]);
    reference::test::addObject(scene, MeshInstance{0, place({0.6, 0.5, -0.5}, 0.3)}, textured[3]);
    reference::test::addObject(scene, Sphere{{-0.5, -0.5, 0}, 0.35}, textured[3]);
    reference::test::addObject(scene, Sphere{{0.5, -0.5, 0.3}, 0.3}, mirror);
    reference::test::addObject(scene, Sphere{{0, -0.6, 0.6}, 0.3}, worn);
    reference::test::addObject(scene, Disk{{0, 0, -0.7}, {0.3, 0, 0}, {0, 0.3, 0.1}}, textured[0]);
    // A ball minus a ball: the hollow shows the coordinates of the second one
    scene.csgLeaves = {{.shape = Sphere{{0, 0.3, 0.2}, 0.3}, .material = textured[2], .where = {}},
                       {.shape = Sphere{{0, 0.5, 0.3}, 0.25}, .material = textured[0], .where = {}}};
    reference::test::addObject(scene, Csg{0, {CsgStep::Leaf, CsgStep::Leaf, CsgStep::Difference}}, std::nullopt);
    return scene;
}

} // namespace

TEST_CASE("textured surfaces have the colours of the reference on every shape") {
    BothSides both(texturedRoom());
    reference::test::Random random;
    const std::uint32_t count = 40000;
    std::vector<shared::Ray> rays;
    std::vector<shared::CameraPath> paths;
    for (std::uint32_t i = 0; i < count; ++i) {
        rays.push_back(toDevice({.origin = random.inCube(0.95), .direction = random.direction()}));
        paths.push_back({vec3(1), i, i, shared::kNone, 0});
    }
    const Bounce bounce = shade(both, rays, paths, 1, 0, Ways::One);
    std::map<std::uint32_t, std::size_t> compared; // by object
    std::size_t edges = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const reference::Ray ray = toReference(rays[i]);
        const auto hit = reference::traceClosest(both.world, ray);
        if (!hit || hit->object != both.sceneObject(bounce.hits.host()[i].object)) {
            continue;
        }
        const reference::CameraPath path{.samplerSeed = paths[i].samplerSeed};
        const auto expected = reference::shadeSurface(both.world, ray, *hit, path, 1, 0);
        double difference = 0;
        if (expected.visible.has_value() != (bounce.visible.host()[i].depth == 1)) {
            ++edges; // of lobe and diffuse part the other one was taken
            continue;
        }
        if (expected.visible) {
            difference = glm::distance(fAt(both, bounce.visible.host()[i]), reference::receiverAt(*expected.visible).f);
        } else if (expected.rough) {
            const reference::Lobe& lobe = expected.rough->lobe;
            const reference::Lobe onDevice = lobeAt(both, bounce.rough.host()[i]);
            difference = std::abs(onDevice.alpha - lobe.alpha) +
                         glm::distance(reference::facetReflectance(onDevice, 1), reference::facetReflectance(lobe, 1));
        } else if (expected.next[0]) {
            REQUIRE(bounce.alive.host()[i] == 1);
            difference = distance(bounce.nextPaths.host()[i].beta, expected.next[0]->path.beta);
        } else {
            continue;
        }
        ++compared[hit->object];
        // Coordinates are accurate to 1e-6 of up to 64 texels, neighbouring texels differ by up to 1 in each channel.
        // Beside the edge of a cell, and at the poles of a sphere, rounding decides.
        edges += difference < 2e-4 ? 0 : 1;
    }
    CHECK(compared.size() == both.scene.objects.size() - 1); // all but the light
    for (const auto& [object, hitCount] : compared) {
        INFO("object " << object);
        CHECK(hitCount > 100);
    }
    CHECK(edges < count / 4000);
}

TEST_CASE("a scene whose materials name no texture has none on the device") {
    Scene scene = texturedRoom();
    for (Material& material : scene.materials) {
        material.colorTexture.reset();
        material.roughnessTexture.reset();
    }
    const BothSides both(scene);
    CHECK(both.deviceScene.specialization.at("kTextures") == 0);
    CHECK(both.deviceScene.textures.count() == 0);
    CHECK(both.deviceScene.textureCoordinates.count() == 0);
}

} // namespace hyalite::testing
