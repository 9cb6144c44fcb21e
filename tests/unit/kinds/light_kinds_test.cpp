// The list of lights: each row's device records match the reference's lights for the same scene.
#include "kinds/lights/light_kinds.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <set>

using namespace hyalite;
using Catch::Matchers::WithinRel;

namespace {

Object emitting(Shape shape, const glm::dvec3& radiance) {
    Object object;
    object.shape = std::move(shape);
    object.emission = radiance;
    return object;
}

// Two of each where a scene may have two.
Scene litScene() {
    Scene scene;
    scene.environment = Environment{.image = Image(4, 2), .scale = 0.5, .rotation = 30};
    for (int x = 0; x < 4; ++x) {
        scene.environment->image.at(x, 0) = {1.0F + static_cast<float>(x), 2, 3};
    }
    scene.lights = {{.position = {0, 1, 0}, .intensity = {1, 2, 3}}, {.position = {1, 1, 0}, .intensity = {3, 1, 2}}};
    scene.spots = {{.position = {0, 2, 0}, .intensity = {4, 5, 6}, .angle = 40, .blend = 0.5}};
    scene.directionals = {{.irradiance = {1, 1, 2}},
                          {.irradiance = {3, 2, 1}, .beam = DirectionalLight::Beam{{0, 3, 0}, 0.5}}};
    scene.meshes = {{.file = {},
                     .positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                     .normals = {},
                     .triangles = {{0, 1, 2}},
                     .uvs = {}}};
    scene.objects = {emitting(Quad{}, {1, 2, 3}), emitting(Disk{}, {2, 2, 1}), emitting(Sphere{}, {0, 1, 5}),
                     emitting(MeshInstance{}, {7, 1, 1})};
    return scene;
}

} // namespace

TEST_CASE("each row of the lights gives device records in the order, kind and power of the reference's lights") {
    const Scene scene = litScene();
    const std::vector<reference::Light> twins = reference::makeLights(scene);
    std::size_t next = 0;
    for (const kinds::LightKind* kind : kinds::kLightKinds) {
        if (kind->addRecords == nullptr) {
            continue;
        }
        REQUIRE(kind->reference.has_value());
        kinds::LightTable table;
        kind->addRecords(scene, table);
        CHECK_FALSE(table.lights.empty()); // the scene above has lights of every kind
        for (const shared::LightRecord& record : table.lights) {
            REQUIRE(next < twins.size());
            CHECK(twins[next].shape.index() == *kind->reference);
            for (int channel = 0; channel < 3; ++channel) {
                // Areas are rounded to floats before they are multiplied
                CHECK_THAT(double{record.power[channel]}, WithinRel(twins[next].power[channel], 4e-7));
            }
            ++next;
        }
    }
    CHECK(next == twins.size());
}

TEST_CASE("the rows of the lights have unique names, and every light has a share of the photons") {
    std::set<std::string_view> names;
    for (const kinds::LightKind* kind : kinds::kLightKinds) {
        CHECK(names.insert(kind->doc.type).second);
        CHECK((kind->read != nullptr) == !kind->doc.type.empty());
        std::set<std::string_view> keys;
        for (const KeyDoc& key : kind->doc.keys) {
            CHECK(keys.insert(key.name).second);
        }
        CHECK(keys.contains("photon_share"));
    }
}
