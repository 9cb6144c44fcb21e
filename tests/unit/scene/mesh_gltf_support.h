// glTF files for tests, put together from numbers.
#pragma once

#include "unit/scene/mesh_test_support.h"

#include "scene/import/gltf_import.h"

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace hyalite::test {

using nlohmann::json;

inline std::string encodeBase64(std::string_view bytes) {
    constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            bits = bits << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        }
        for (unsigned k = 0; k < 4; ++k) {
            text += i + k <= bytes.size() ? kAlphabet[bits >> (18 - 6 * k) & 63U] : '=';
        }
    }
    return text;
}

template <class T>
std::string bytesOf(const std::vector<T>& values) {
    std::string bytes;
    for (const T& value : values) {
        put(bytes, value, false);
    }
    return bytes;
}

inline std::string bytesOf(const std::vector<glm::vec3>& values) {
    std::string bytes;
    for (const glm::vec3& value : values) {
        for (int axis = 0; axis < 3; ++axis) {
            put(bytes, value[axis], false);
        }
    }
    return bytes;
}

constexpr int kByte = 5120;
constexpr int kUnsignedByte = 5121;
constexpr int kShort = 5122;
constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;

// A document that grows by what is added to it; tests change `document` at will before they take the bytes.
struct Gltf {
    json document{{"asset", {{"version", "2.0"}}}, {"scenes", {{{"nodes", {0}}}}}, {"nodes", {{{"mesh", 0}}}}};
    std::string buffer;

    // Adds bytes to the buffer and a view of them; returns its index.
    std::size_t addView(const std::string& bytes, std::size_t stride = 0) {
        json view{{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}};
        if (stride > 0) {
            view["byteStride"] = stride;
        }
        buffer += bytes;
        document["bufferViews"].push_back(view);
        return document["bufferViews"].size() - 1;
    }
    std::size_t addAccessor(json accessor) {
        document["accessors"].push_back(std::move(accessor));
        return document["accessors"].size() - 1;
    }
    std::size_t add(const std::string& bytes, const std::string& type, int componentType, std::size_t count) {
        return addAccessor(
            {{"bufferView", addView(bytes)}, {"type", type}, {"componentType", componentType}, {"count", count}});
    }
    std::size_t addPositions(const std::vector<glm::vec3>& positions) {
        return add(bytesOf(positions), "VEC3", kFloat, positions.size());
    }
    template <class T>
    std::size_t addIndices(const std::vector<T>& indices, int componentType) {
        return add(bytesOf(indices), "SCALAR", componentType, indices.size());
    }
    // Adds a primitive to the first mesh.
    json& addPrimitive(std::size_t positions) {
        json& list = document["meshes"][0]["primitives"];
        list.push_back({{"attributes", {{"POSITION", positions}}}});
        return list.back();
    }

    // As a .gltf file with its buffer within.
    [[nodiscard]] std::string text() const {
        json whole = document;
        if (!whole.contains("buffers")) {
            const std::string uri = "data:application/octet-stream;base64," + encodeBase64(buffer);
            whole["buffers"] = {{{"uri", uri}, {"byteLength", buffer.size()}}};
        }
        return whole.dump();
    }
    // As a .glb file.
    [[nodiscard]] std::string binary() const {
        json whole = document;
        whole["buffers"] = {{{"byteLength", buffer.size()}}};
        std::string text = whole.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::string data = buffer;
        data.resize((data.size() + 3) / 4 * 4, '\0');
        std::string bytes = "glTF";
        put(bytes, std::uint32_t{2}, false);
        put(bytes, static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + data.size()), false);
        put(bytes, static_cast<std::uint32_t>(text.size()), false);
        bytes += "JSON" + text;
        put(bytes, static_cast<std::uint32_t>(data.size()), false);
        bytes += std::string("BIN\0", 4) + data;
        return bytes;
    }
};

inline std::vector<std::uint32_t> pyramidIndices() {
    std::vector<std::uint32_t> indices;
    for (const glm::uvec3& t : kTriangles) {
        indices.insert(indices.end(), {t.x, t.y, t.z});
    }
    return indices;
}

// The pyramid as one indexed primitive.
inline Gltf pyramidGltf() {
    Gltf gltf;
    const std::size_t positions = gltf.addPositions(kCorners);
    const std::size_t indices = gltf.addIndices(pyramidIndices(), kUnsignedInt);
    gltf.addPrimitive(positions)["indices"] = indices;
    return gltf;
}

inline ImportedFile parse(const std::string& bytes) {
    return parseGltf(bytes, "m.gltf", {});
}

// The only mesh of a file with one part.
inline Mesh onlyMesh(const std::string& bytes) {
    const ImportedFile file = parse(bytes);
    REQUIRE(file.meshes.size() == 1);
    REQUIRE(file.parts.size() == 1);
    return file.meshes[0];
}

inline void checkGltfRejected(const std::string& bytes, const std::string& what) {
    const auto error = errorOf([&] { static_cast<void>(parse(bytes)); });
    INFO("expected: " << what);
    REQUIRE(error.has_value());
    CHECK(error->code() == ExitCode::BadInput);
    CHECK(error->where().file == "m.gltf");
    CHECK_THAT(error->what(), Catch::Matchers::ContainsSubstring(what));
}

} // namespace hyalite::test
