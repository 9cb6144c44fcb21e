#include "live/worker/path_json.h"

namespace hyalite::live {

namespace {

Json listOf(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

Json describe(const parity::Vertex& vertex, const Scene& scene) {
    const auto nameOf = [&](std::uint32_t material) {
        return material < scene.materials.size() ? scene.materials[material].name : std::string();
    };
    Json json{{"depth", vertex.depth},
              {"seed", vertex.seed},
              {"hit", vertex.object != shared::kNone},
              {"throughput", listOf(vertex.weight)},
              {"direction", listOf(vertex.direction)},
              {"medium", nameOf(vertex.medium)},
              {"choice", parity::describeChoice(vertex)}};
    if (vertex.object != shared::kNone) {
        json["object"] = vertex.object;
        json["material"] = nameOf(vertex.material);
        json["side"] = vertex.front ? "front" : "back";
        json["position"] = listOf(vertex.position);
        json["normal"] = listOf(vertex.normal);
    }
    return json;
}

template <class Vertices>
Json listOf(const Vertices& vertices, const Scene& scene) {
    constexpr std::size_t kMost = 64; // vertices of a tree of paths
    Json list = Json::array();
    for (std::size_t i = 0; i < std::min(vertices.size(), kMost); ++i) {
        list.push_back(describe(vertices[i], scene));
    }
    return list;
}

} // namespace

Json describe(const parity::RecordedPath& path, const Scene& scene) {
    return {{"device", listOf(path.device, scene)},
            {"twin", listOf(path.twin, scene)},
            {"differs_at", path.differsAt},
            {"what", path.what},
            {"cause", path.cause}};
}

} // namespace hyalite::live
