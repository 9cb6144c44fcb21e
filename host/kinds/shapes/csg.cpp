// Constructive solid geometry: combinations of solids. Device: shaders/shapes/csg.glsl; reference:
// host/reference/shapes/csg.cpp.
#include "base/spelling.h"
#include "kinds/shapes/object_record.h"
#include "kinds/shapes/shape_kinds.h"
#include "scene/model/bounds.h"
#include "scene/model/mesh_topology.h"
#include "scene/model/quadric.h"
#include "scene/yaml/find_material.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace hyalite::kinds {
namespace {

constexpr std::array<std::string_view, 3> kOperationNames{"union", "intersection", "difference"};
constexpr KeyDoc kOp{.name = "op",
                     .type = KeyType::Word,
                     .required = true,
                     .text =
                         "`union`: in either; `intersection`: in both; `difference`: in the left and not in the right",
                     .words = kOperationNames};
constexpr KeyDoc kLeft{.name = "left",
                       .type = KeyType::Other,
                       .text = "an operand",
                       .schema = R"({"$ref": "#/$defs/solid"})",
                       .typeText = "shape"};
constexpr KeyDoc kRight{.name = "right",
                        .type = KeyType::Other,
                        .text = "the other operand",
                        .schema = R"({"$ref": "#/$defs/solid"})",
                        .typeText = "shape"};
constexpr KeyDoc kShapes{.name = "shapes",
                         .type = KeyType::Other,
                         .text = "instead of `left` and `right`: A op B op C …, from the left",
                         .schema =
                             R"({"type": "array", "items": {"$ref": "#/$defs/solid"}, "minItems": 2, "maxItems": 32})",
                         .typeText = "list of shapes, at least 2"};
constexpr KeyDoc kCutMaterial{.name = "cut_material",
                              .type = KeyType::Text,
                              .defaultText = "none",
                              .text = "for a difference: material of the faces that all operands but the first cut"};
constexpr std::array kKeys{kOp, kLeft, kRight, kShapes, kCutMaterial};

constexpr std::array<Choice<CsgStep>, 3> kOperations{{
    {"union", CsgStep::Union},
    {"intersection", CsgStep::Intersection},
    {"difference", CsgStep::Difference},
}};

// Reads the operands: `left` and `right`, or `shapes`.
std::vector<Value> readOperands(Reader& reader) {
    const auto shapes = reader.find(kShapes.name);
    const auto left = reader.find(kLeft.name);
    const auto right = reader.find(kRight.name);
    if (!shapes) {
        if (!left && !right) {
            reader.map().fail("a csg needs operands", "give 'left' and 'right', or a list of 'shapes'");
        }
        return {reader.require(kLeft.name), reader.require(kRight.name)};
    }
    if (left || right) {
        (left ? left : right)->fail("a csg has either 'shapes' or 'left' and 'right', not both");
    }
    std::vector<Value> operands;
    for (const Value& shape : shapes->list()) {
        operands.emplace_back(shape.node(), shape.file(), "shape");
    }
    if (operands.size() < 2) {
        shapes->fail("a csg needs at least 2 'shapes', found " + std::to_string(operands.size()));
    }
    return operands;
}

[[noreturn]] void failNotClosed(const SourceLocation& where, const std::string& what, const std::string& hint = {}) {
    throw Error(ExitCode::BadInput, where, what + ": it cannot be part of a csg", hint);
}

void checkClosedMesh(const SourceLocation& where, const Mesh& mesh) {
    const auto text = [&](const glm::vec3& inMesh) {
        const glm::dvec3 point = mesh.origin + glm::dvec3(inMesh);
        return '(' + numberText(point.x) + ", " + numberText(point.y) + ", " + numberText(point.z) + ')';
    };
    if (const auto edge = findOpenEdge(mesh)) {
        failNotClosed(
            where, "this mesh is open at the edge from " + text(edge->from) + " to " + text(edge->to) + " of its file",
            "every edge must have a triangle on both sides");
    }
    const double volume = signedVolume(mesh);
    if (volume == 0) {
        failNotClosed(where, "this mesh encloses nothing");
    }
    if (volume < 0) {
        failNotClosed(where, "this mesh is inside out: the fronts of its triangles face inward",
                      "reverse the order of their corners");
    }
}

// Checks that the shape has an inside and can be a leaf.
void checkSolid(const Object& leaf, const Scene& scene) {
    if (std::holds_alternative<Quad>(leaf.shape)) {
        failNotClosed(leaf.where, "a quad has no inside", "use a plane (the half-space behind it) or a box");
    }
    if (std::holds_alternative<Disk>(leaf.shape)) {
        failNotClosed(leaf.where, "a disk has no inside", "use a flat cylinder");
    }
    if (const auto* quadric = std::get_if<Quadric>(&leaf.shape)) {
        const bool isCut =
            quadric->clip.low != Bounds::everything().low || quadric->clip.high != Bounds::everything().high;
        if (isCut && !quadric->capped) {
            failNotClosed(leaf.where, "this shape is open without its caps", "leave the caps on");
        }
    }
    if (const auto* instance = std::get_if<MeshInstance>(&leaf.shape)) {
        const auto isSame = [&](const Object& earlier) {
            const auto* other = std::get_if<MeshInstance>(&earlier.shape);
            return other != nullptr && other->mesh == instance->mesh;
        };
        // A mesh that is a leaf already has passed the check
        if (std::none_of(scene.csgLeaves.begin(), scene.csgLeaves.end(), isSame)) {
            checkClosedMesh(leaf.where, scene.meshes[instance->mesh]);
        }
    }
}

// Reads one operand and adds its steps to the program.
void readOperand(const Value& value, const Surroundings& around, std::vector<CsgStep>& program) {
    const Object operand = around.readShape(value, around);
    if (const auto* csg = std::get_if<Csg>(&operand.shape)) { // its leaves are in place already
        program.insert(program.end(), csg->program.begin(), csg->program.end());
        return;
    }
    checkSolid(operand, around.scene);
    if (!operand.material) {
        value.fail("this shape has no material", "give one to it, to an enclosing csg or to the object");
    }
    around.scene.csgLeaves.push_back(operand);
    program.push_back(CsgStep::Leaf);
}

Shape read(Reader& reader, const Surroundings& around) {
    const auto operation = choose<CsgStep>(reader.require(kOp.name), "operation", kOperations);
    const std::vector<Value> operands = readOperands(reader);
    const auto cutMaterial = reader.find(kCutMaterial.name);
    reader.finish(); // report a wrong key before reading meshes

    Surroundings right = around;
    if (cutMaterial) {
        if (operation != CsgStep::Difference) {
            cutMaterial->fail("only a difference has cut faces for 'cut_material'");
        }
        const std::size_t material = findMaterial(*cutMaterial, around.scene);
        right.cutMaterial = around.cutMaterial.value_or(material); // the outermost one wins
    }
    Csg csg{around.scene.csgLeaves.size(), {}};
    for (std::size_t i = 0; i < operands.size(); ++i) {
        readOperand(operands[i], i == 0 ? around : right, csg.program);
        if (i > 0) {
            csg.program.push_back(operation);
        }
        if (around.scene.csgLeaves.size() - csg.firstLeaf > kMostCsgLeaves) {
            reader.map().fail("this csg has more than " + std::to_string(kMostCsgLeaves) + " shapes",
                              "split it into several objects, or use a mesh");
        }
    }
    Object whole;
    whole.shape = csg;
    if (operation == CsgStep::Intersection && isEmpty(worldBounds(around.scene, whole))) {
        reader.map().fail("this intersection is empty: its shapes do not overlap");
    }
    return csg;
}

constexpr double kEndlessRadius = 3e38; // stored for an endless solid: no ray starts outside this sphere

std::uint32_t code(CsgStep step) {
    switch (step) {
    case CsgStep::Leaf:
        return shared::kCsgLeaf;
    case CsgStep::Union:
        return shared::kCsgUnion;
    case CsgStep::Intersection:
        return shared::kCsgIntersection;
    case CsgStep::Difference:
        break;
    }
    return shared::kCsgDifference;
}

} // namespace

ObjectRecord record(const Csg& csg, ObjectTables& tables) {
    const std::uint32_t leaves = leafCount(csg);
    ObjectRecord r{.type = shared::kShapeCsg, .root = static_cast<std::uint32_t>(tables.geometry.size())};
    const CsgExtent extent = csgExtent(tables.scene, csg);
    const double radius = std::isfinite(extent.radius) ? extent.radius : kEndlessRadius;
    r.texels[0] = glm::vec4(bits(tables.nextLeaf), bits(leaves), static_cast<float>(extent.reach), 0);
    r.texels[1] = glm::vec4(glm::vec3(extent.center), static_cast<float>(radius));
    tables.nextLeaf += leaves;
    glm::uvec4 words(0);
    for (std::uint32_t i = 0; i < csg.program.size(); ++i) {
        words[static_cast<int>(i / 16)] |= code(csg.program[i]) << 2 * (i % 16);
    }
    tables.geometry.push_back(words);
    return r;
}

std::uint32_t leafCount(const Csg& csg) {
    return static_cast<std::uint32_t>((csg.program.size() + 1) / 2);
}

std::vector<std::uint32_t> leafTypes(const Csg& csg) {
    std::vector<std::uint32_t> types;
    std::vector<std::size_t> stack; // first leaf of each operand
    for (const CsgStep step : csg.program) {
        if (step == CsgStep::Leaf) {
            stack.push_back(types.size());
            types.push_back(shared::kShapeLeaf | shared::kShapeRequired);
            continue;
        }
        const std::size_t right = stack.back();
        stack.pop_back();
        for (std::size_t leaf = stack.back(); leaf < types.size(); ++leaf) {
            const bool isTakenOff = step == CsgStep::Difference && leaf >= right;
            types[leaf] ^= isTakenOff ? shared::kShapeReversed : 0;
            if (isTakenOff || step == CsgStep::Union) {
                types[leaf] &= ~shared::kShapeRequired;
            }
        }
    }
    return types;
}

constinit const ShapeKind kCsgShape{.doc = {.type = "csg",
                                            .schemaName = "csg",
                                            .text = "A combination of solids.",
                                            .keys = kKeys,
                                            .rules =
                                                R"({"oneOf": [
        {"required": ["left", "right"], "not": {"required": ["shapes"]}},
        {"required": ["shapes"], "not": {"anyOf": [{"required": ["left"]}, {"required": ["right"]}]}}
      ],
      "if": {"required": ["cut_material"]},
      "then": {"properties": {"op": {"const": "difference"}}}})"},
                                    .read = read};

} // namespace hyalite::kinds
