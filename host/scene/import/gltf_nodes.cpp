// See gltf_nodes.h.
#include "scene/import/gltf_nodes.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <iterator>

namespace hyalite {
namespace {

constexpr double kFarthest = 1e30; // of a transform's numbers: products of a few hundred are not checked one by one

glm::dmat4 readMatrix(const GltfValue& value) {
    const std::vector<double> numbers = value.numbers(16, -kFarthest, kFarthest); // column by column, as glm has them
    const glm::dmat4 matrix = glm::make_mat4(numbers.data());
    if (numbers[3] != 0 || numbers[7] != 0 || numbers[11] != 0 || numbers[15] != 1) {
        value.fail("the last row of the matrix must be 0, 0, 0, 1", "its 16 numbers are read column by column");
    }
    return matrix;
}

// The node's own map: a matrix, or a scale, then a rotation, then a translation.
glm::dmat4 readTransform(const GltfValue& node) {
    const auto translation = node.find("translation");
    const auto rotation = node.find("rotation");
    const auto scale = node.find("scale");
    if (const auto matrix = node.find("matrix")) {
        if (translation || rotation || scale) {
            matrix->fail("a node has either a matrix or translation, rotation and scale");
        }
        return readMatrix(*matrix);
    }
    glm::dmat4 map(1);
    if (translation) {
        map = glm::translate(map, glm::make_vec3(translation->numbers(3, -kFarthest, kFarthest).data()));
    }
    if (rotation) {
        const std::vector<double> q = rotation->numbers(4, -1.5, 1.5); // x, y, z, w of a unit quaternion, roughly
        const glm::dquat quaternion(q[3], q[0], q[1], q[2]);
        if (!(glm::length(quaternion) > 0.5)) {
            rotation->fail("a rotation must be a unit quaternion");
        }
        map *= glm::mat4_cast(glm::normalize(quaternion));
    }
    if (scale) {
        map = glm::scale(map, glm::make_vec3(scale->numbers(3, -kFarthest, kFarthest).data()));
    }
    return map;
}

// Nodes that are no node's child.
std::vector<std::size_t> findRoots(const GltfDocument& document, const GltfValue& nodes) {
    std::vector<bool> isChild(nodes.size(), false);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (const auto children = nodes.at(i).find("children")) {
            for (std::size_t k = 0; k < children->size(); ++k) {
                isChild[children->at(k).index(document.root(), "nodes")] = true;
            }
        }
    }
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < isChild.size(); ++i) {
        if (!isChild[i]) {
            roots.push_back(i);
        }
    }
    return roots;
}

std::vector<std::size_t> sceneRoots(const GltfDocument& document, const GltfValue& nodes) {
    const auto scenes = document.root().find("scenes");
    if (!scenes || scenes->size() == 0) {
        return findRoots(document, nodes);
    }
    const auto chosen = document.root().find("scene");
    const GltfValue scene = scenes->at(chosen ? chosen->index(document.root(), "scenes") : 0);
    std::vector<std::size_t> roots;
    if (const auto list = scene.find("nodes")) {
        for (std::size_t i = 0; i < list->size(); ++i) {
            roots.push_back(list->at(i).index(document.root(), "nodes"));
        }
    }
    return roots;
}

} // namespace

std::vector<GltfPlacement> placeGltfMeshes(GltfDocument& document) {
    const auto nodes = document.root().find("nodes");
    if (!nodes) {
        return {};
    }
    struct Open {
        std::size_t node;
        glm::dmat4 parentToFile;
    };
    std::vector<Open> open;
    const auto pushAll = [&](const std::vector<std::size_t>& list, const glm::dmat4& toFile) {
        std::transform(list.rbegin(), list.rend(), std::back_inserter(open), // the first is walked first
                       [&](std::size_t node) { return Open{node, toFile}; });
    };
    pushAll(sceneRoots(document, *nodes), glm::dmat4(1));

    std::vector<GltfPlacement> placements;
    std::vector<bool> isReached(nodes->size(), false);
    while (!open.empty()) {
        const auto [index, parentToFile] = open.back();
        open.pop_back();
        const GltfValue node = nodes->at(index);
        if (isReached[index]) { // also ends a walk around a cycle
            node.fail("the node is reached more than once", "the nodes of a scene must form trees");
        }
        isReached[index] = true;
        const glm::dmat4 toFile = parentToFile * readTransform(node);
        if (const auto mesh = node.find("mesh")) {
            if (const auto skin = node.find("skin")) {
                skin->fail("skinned meshes are not supported", "export the mesh in its pose, without its skeleton");
            }
            placements.push_back({index, mesh->index(document.root(), "meshes"), toFile});
        }
        if (const auto children = node.find("children")) {
            std::vector<std::size_t> list;
            for (std::size_t k = 0; k < children->size(); ++k) {
                list.push_back(children->at(k).index(document.root(), "nodes"));
            }
            pushAll(list, toFile);
        }
    }
    return placements;
}

} // namespace hyalite
