// See kinds_format.h.
#include "describe/kinds_format.h"

#include "describe/generated_parts.h"
#include "kinds/lights/light_kinds.h"
#include "kinds/materials/material_kinds.h"
#include "kinds/shapes/shape_kinds.h"
#include "scene/model/warning.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace hyalite::describe {
namespace {

// A definition of the schema: one type of a kind, or several that have the same keys.
struct Definition {
    MapDoc map;
    std::vector<std::string_view> types;
};

// The rows of a list of kinds by definition, in the order of the list; without the rows that have no type.
template <class Kinds>
std::vector<Definition> definitionsOf(const Kinds& kinds) {
    std::vector<Definition> all;
    for (const auto* kind : kinds) {
        const MapDoc& map = kind->doc;
        const auto same = std::ranges::find(all, map.schemaName, [](const Definition& d) { return d.map.schemaName; });
        if (same != all.end()) {
            same->types.push_back(map.type);
        } else if (!map.type.empty()) {
            all.push_back({map, {map.type}});
        }
    }
    return all;
}

// The schema with a definition for each of `all`; new ones stand before the definition `next`.
std::string withDefinitions(std::string schema, const std::string& next, const std::vector<Definition>& all) {
    for (const Definition& one : all) {
        const std::string name(one.map.schemaName);
        schema = withDefinition(withPlaceFor(schema, name, next), name, definition(one.map, one.types));
    }
    return schema;
}

// {"oneOf": [...]} of the definitions.
std::string choiceOf(std::span<const std::string> names) {
    std::string text;
    for (const std::string& name : names) {
        text += (text.empty() ? "        {\"$ref\": \"#/$defs/" : ",\n        {\"$ref\": \"#/$defs/") + name + "\"}";
    }
    return "{\n      \"oneOf\": [\n" + text + "\n      ]\n    }";
}

std::vector<std::string> namesOf(const std::vector<Definition>& all) {
    std::vector<std::string> names;
    for (const Definition& one : all) {
        names.emplace_back(one.map.schemaName);
    }
    return names;
}

// The shapes with the keys that all have.
struct ShapeDefinitions {
    std::vector<Definition> all = definitionsOf(kinds::kShapeKinds);
    std::vector<std::vector<KeyDoc>> keys; // storage that `all` refers to

    ShapeDefinitions() {
        for (Definition& shape : all) {
            std::vector<KeyDoc>& own = keys.emplace_back(shape.map.keys.begin(), shape.map.keys.end());
            own.insert(own.end(), kinds::kKeysOfAllShapes.begin(), kinds::kKeysOfAllShapes.end());
        }
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i].map.keys = keys[i];
        }
    }
};

// Names of the definitions of shapes that are solids, or of those that are not.
std::vector<std::string> shapeNames(bool solid) {
    std::vector<std::string> names;
    for (const kinds::ShapeKind* kind : kinds::kShapeKinds) {
        const std::string name(kind->doc.schemaName);
        if (kind->isSolid == solid && std::ranges::find(names, name) == names.end()) {
            names.push_back(name);
        }
    }
    return names;
}

template <class Kinds>
std::vector<MapDoc> typesOf(const Kinds& kinds) {
    std::vector<MapDoc> types;
    for (const auto* kind : kinds) {
        if (!kind->doc.type.empty()) {
            types.push_back(kind->doc);
        }
    }
    return types;
}

} // namespace

std::string schemaWithKinds(std::string schema) {
    const std::vector<Definition> materials = definitionsOf(kinds::kMaterialKinds);
    schema = withDefinitions(schema, "material", materials);
    schema = withDefinition(schema, "material", choiceOf(namesOf(materials)));

    const std::vector<Definition> lights = definitionsOf(kinds::kLightKinds);
    schema = withDefinitions(schema, "light", lights);
    schema = withDefinition(schema, "light", choiceOf(namesOf(lights)));
    for (const KeyDoc& key : kinds::kAreaLight.doc.keys) { // those of an object that is a light
        const std::string name(key.name);
        schema = withDefinition(withPlaceFor(schema, name, "light"), name, definition(key));
    }

    std::string warnings;
    for (const WarningRow& row : kWarningRows) {
        warnings += (warnings.empty() ? "\"" : ", \"") + std::string(row.name) + '"';
    }
    schema = withDefinition(schema, "warning", "{\"enum\": [" + warnings + "]}");

    schema = withDefinitions(schema, "shape", ShapeDefinitions().all);
    std::vector<std::string> shapes = shapeNames(false);
    shapes.insert(shapes.begin(), "solid");
    schema = withDefinition(schema, "shape", choiceOf(shapes));
    return withDefinition(schema, "solid", choiceOf(shapeNames(true)));
}

std::string docsWithKinds(std::string markdown) {
    markdown = withGenerated(markdown, "materials", typeTable(typesOf(kinds::kMaterialKinds)));
    markdown = withGenerated(markdown, "lights", typeTable(typesOf(kinds::kLightKinds), {&kinds::kPhotonShare, 1}));
    markdown = withGenerated(markdown, "all shapes", keyTable(kinds::kKeysOfAllShapes));
    for (const Definition& shape : definitionsOf(kinds::kShapeKinds)) {
        markdown = withGenerated(markdown, std::string(shape.map.schemaName), keyTable(shape.map.keys));
    }
    std::string warnings = "| warning | given when |\n|---|---|\n";
    for (const WarningRow& row : kWarningRows) {
        warnings += "| `" + std::string(row.name) + "` | " + std::string(row.text) + " |\n";
    }
    return withGenerated(markdown, "warnings", warnings);
}

} // namespace hyalite::describe
