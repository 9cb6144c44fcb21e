// See read_csg.h.
#include "scene/load/read_csg.h"

#include "base/spelling.h"
#include "scene/load/read_materials.h"
#include "scene/model/bounds.h"
#include "scene/model/mesh_topology.h"
#include "scene/model/quadric.h"

#include <algorithm>
#include <array>
#include <string>

namespace hyalite {
namespace {

constexpr std::array<Choice<CsgStep>, 3> kOperations{{
    {"union", CsgStep::Union},
    {"intersection", CsgStep::Intersection},
    {"difference", CsgStep::Difference},
}};

// The operands as the file gives them: `left` and `right`, or `shapes`.
std::vector<Value> readOperands(Reader& reader) {
    const auto shapes = reader.find("shapes");
    const auto left = reader.find("left");
    const auto right = reader.find("right");
    if (!shapes) {
        if (!left && !right) {
            reader.map().fail("a csg needs its operands", "'left' and 'right', or a list of 'shapes'");
        }
        return {reader.require("left"), reader.require("right")};
    }
    if (left || right) {
        (left ? left : right)->fail("a csg has either 'shapes' or 'left' and 'right', not both");
    }
    std::vector<Value> operands;
    for (const Value& shape : shapes->list()) {
        operands.emplace_back(shape.node(), shape.file(), "shape");
    }
    if (operands.size() < 2) {
        shapes->fail("'shapes' of a csg must be at least 2, found " + std::to_string(operands.size()));
    }
    return operands;
}

[[noreturn]] void failNotClosed(const SourceLocation& where, const std::string& what, const std::string& hint = {}) {
    throw Error(ExitCode::BadInput, where, what + ": it cannot be part of a csg", hint);
}

void checkClosedMesh(const SourceLocation& where, const Mesh& mesh) {
    const auto text = [](const glm::vec3& point) {
        return '(' + numberText(point.x) + ", " + numberText(point.y) + ", " + numberText(point.z) + ')';
    };
    if (const auto edge = findOpenEdge(mesh)) {
        failNotClosed(
            where, "this mesh is open, at the edge from " + text(edge->from) + " to " + text(edge->to) + " of its file",
            "every edge must have a triangle on either side");
    }
    const double volume = signedVolume(mesh);
    if (volume == 0) {
        failNotClosed(where, "this mesh encloses nothing");
    }
    if (volume < 0) {
        failNotClosed(where, "this mesh is inside out: the fronts of its triangles face inward",
                      "turn the order of their corners round");
    }
}

// Only what has an inside can be a leaf.
void checkSolid(const Object& leaf, const Scene& scene) {
    if (std::holds_alternative<Quad>(leaf.shape)) {
        failNotClosed(leaf.where, "a quad has no inside", "a plane stands for all that is behind it, or use a box");
    }
    if (std::holds_alternative<Disk>(leaf.shape)) {
        failNotClosed(leaf.where, "a disk has no inside", "use a flat cylinder");
    }
    if (const auto* quadric = std::get_if<Quadric>(&leaf.shape)) {
        const bool isCut =
            quadric->clip.low != Bounds::everything().low || quadric->clip.high != Bounds::everything().high;
        if (isCut && !quadric->capped) {
            failNotClosed(leaf.where, "this shape is open where its caps are left off", "give it its caps");
        }
    }
    if (const auto* instance = std::get_if<MeshInstance>(&leaf.shape)) {
        const auto isSame = [&](const Object& earlier) {
            const auto* other = std::get_if<MeshInstance>(&earlier.shape);
            return other != nullptr && other->mesh == instance->mesh;
        };
        // What is a leaf already has passed
        if (std::none_of(scene.csgLeaves.begin(), scene.csgLeaves.end(), isSame)) {
            checkClosedMesh(leaf.where, scene.meshes[instance->mesh]);
        }
    }
}

// Reads one operand and adds its steps to the program.
void readOperand(const Value& value, const Surroundings& around, std::vector<CsgStep>& program) {
    const Object operand = readShape(value, around);
    if (const auto* csg = std::get_if<Csg>(&operand.shape)) { // its leaves are where they belong
        program.insert(program.end(), csg->program.begin(), csg->program.end());
        return;
    }
    checkSolid(operand, around.scene);
    if (!operand.material) {
        value.fail("this shape has no material", "give one to it, to a csg around it or to the object");
    }
    around.scene.csgLeaves.push_back(operand);
    program.push_back(CsgStep::Leaf);
}

} // namespace

Shape readCsg(Reader& reader, const Surroundings& around) {
    const auto operation = choose<CsgStep>(reader.require("op"), "operation", kOperations);
    const std::vector<Value> operands = readOperands(reader);
    const auto cutMaterial = reader.find("cut_material");
    reader.finish(); // before meshes are read for nothing

    Surroundings right = around;
    if (cutMaterial) {
        if (operation != CsgStep::Difference) {
            cutMaterial->fail("only a difference has cut faces for 'cut_material'");
        }
        const std::size_t material = findMaterial(*cutMaterial, around.scene);
        right.cutMaterial = around.cutMaterial.value_or(material); // the outermost holds for all that it cuts
    }
    Csg csg{around.scene.csgLeaves.size(), {}};
    for (std::size_t i = 0; i < operands.size(); ++i) {
        readOperand(operands[i], i == 0 ? around : right, csg.program);
        if (i > 0) {
            csg.program.push_back(operation);
        }
        if (around.scene.csgLeaves.size() - csg.firstLeaf > kMostCsgLeaves) {
            reader.map().fail("this csg has more than " + std::to_string(kMostCsgLeaves) + " shapes",
                              "make several objects of it, or a mesh");
        }
    }
    Object whole;
    whole.shape = csg;
    if (operation == CsgStep::Intersection && isEmpty(worldBounds(around.scene, whole))) {
        reader.map().fail("nothing is left of this csg: its shapes do not meet");
    }
    return csg;
}

} // namespace hyalite
