// Key documentation rows as Markdown tables and JSON schemas.
#include "base/error.h"
#include "describe/generated_parts.h"
#include "describe/key_text.h"
#include "unit/scene/scene_test_support.h"

#include <array>
#include <nlohmann/json.hpp>

using namespace hyalite;
using namespace hyalite::test;

namespace {

constexpr std::array<std::string_view, 2> kWords{"left", "right"};

// One key of each type.
const std::array<KeyDoc, 10> kKeys{{
    {.name = "size",
     .range = {1e-9, 1e9, true, true, "m"},
     .required = true,
     .text = "edge of a cell, see [cells](cells.md)"},
    {.name = "share", .range = {0, 1, false, false}, .defaultText = "2/3", .text = "of the `light`"},
    {.name = "count",
     .type = KeyType::WholeNumber,
     .range = {.low = 2, .high = 64, .orZero = true},
     .defaultText = "0"},
    {.name = "open", .type = KeyType::Flag, .defaultText = "false"},
    {.name = "side", .type = KeyType::Word, .defaultText = "left", .words = kWords},
    {.name = "file", .type = KeyType::Text, .required = true},
    {.name = "center", .type = KeyType::Vector, .range = {-1e9, 1e9, true, true, "m"}, .defaultText = "[0, 0, 0]"},
    {.name = "albedo", .type = KeyType::TexturedColor, .range = {0, 1}, .defaultText = "0.5"},
    {.name = "pair", .type = KeyType::WholePair, .range = {1, 8}, .defaultText = "none"},
    {.name = "edges",
     .type = KeyType::Other,
     .required = true,
     .schema = R"({"type": "array", "minItems": 2})",
     .typeText = "two vectors",
     .rangeText = "not parallel"},
}};

} // namespace

TEST_CASE("a table has a row for each key, in the scene format's terms") {
    CHECK(describe::keyTable(kKeys) ==
          "| key | type | unit | default | range | meaning |\n"
          "|---|---|---|---|---|---|\n"
          "| `size` | number | m | | [1e-9, 1e9] | edge of a cell, see [cells](cells.md) |\n"
          "| `share` | number | | 2/3 | (0, 1) | of the `light` |\n"
          "| `count` | whole number | | 0 | 0, or [2, 64] | |\n"
          "| `open` | true or false | | false | | |\n"
          "| `side` | text | | left | `left`, `right` | |\n"
          "| `file` | text | | | | |\n"
          "| `center` | vector | m | [0, 0, 0] | | |\n" // every coordinate has that range
          "| `albedo` | textured colour | | 0.5 | each [0, 1] | |\n"
          "| `pair` | two whole numbers | | none | each [1, 8] | |\n"
          "| `edges` | two vectors | | | not parallel | |\n");
    CHECK(describe::keyTable({&kKeys[3], 1}, "who", {"all"}) ==
          "| key | type | unit | default | range | who | meaning |\n"
          "|---|---|---|---|---|---|---|\n"
          "| `open` | true or false | | false | | all | |\n");
}

TEST_CASE("a table of types names each type at its first key") {
    const std::array<MapDoc, 2> types{
        {{.type = "cells", .keys = std::span(kKeys).first(2)}, {.type = "plain", .text = "has no keys"}}};
    CHECK(describe::typeTable(types) ==
          "| type | key | kind | unit | default | range | meaning |\n"
          "|---|---|---|---|---|---|---|\n"
          "| `cells` | `size` | number | m | | [1e-9, 1e9] | edge of a cell, see [cells](cells.md) |\n"
          "| | `share` | number | | 2/3 | (0, 1) | of the `light` |\n"
          "| `plain` | | | | | | has no keys |\n");
    // Keys that all types share come once, at the end.
    CHECK(describe::typeTable({types.data(), 1}, {&kKeys[1], 1}) ==
          "| type | key | kind | unit | default | range | meaning |\n"
          "|---|---|---|---|---|---|---|\n"
          "| `cells` | `size` | number | m | | [1e-9, 1e9] | edge of a cell, see [cells](cells.md) |\n"
          "| all | `share` | number | | 2/3 | (0, 1) | of the `light` |\n");
}

TEST_CASE("a definition is a JSON schema of the map") {
    const std::string text =
        describe::definition({.type = "cells", .keys = kKeys, .rules = R"({"not": {"required": ["pair", "open"]}})"});
    const auto schema = nlohmann::json::parse(text);
    CHECK(schema.at("type") == "object");
    CHECK(schema.at("required") == nlohmann::json{"type", "size", "file", "edges"});
    CHECK(schema.at("additionalProperties") == false);
    CHECK(schema.at("not").at("required").size() == 2);
    const auto& keys = schema.at("properties");
    CHECK(keys.size() == kKeys.size() + 1);
    CHECK(keys.at("type") == nlohmann::json{{"const", "cells"}});
    CHECK(keys.at("size") == nlohmann::json{{"description", "edge of a cell, see cells [m]"},
                                            {"type", "number"},
                                            {"minimum", 1e-9},
                                            {"maximum", 1e9}});
    CHECK(keys.at("share") == nlohmann::json{{"description", "of the light"},
                                             {"type", "number"},
                                             {"exclusiveMinimum", 0},
                                             {"exclusiveMaximum", 1},
                                             {"default", 2.0 / 3}});
    CHECK(keys.at("count").at("anyOf").at(0).at("const") == 0);
    CHECK(keys.at("count").at("anyOf").at(1).at("minimum") == 2);
    CHECK(keys.at("count").at("default") == 0);
    CHECK(keys.at("open") == nlohmann::json{{"type", "boolean"}, {"default", false}});
    CHECK(keys.at("side") == nlohmann::json{{"enum", {"left", "right"}}, {"default", "left"}});
    CHECK(keys.at("file").at("type").size() == 3);
    CHECK(keys.at("center").at("$ref") == "#/$defs/vector");
    CHECK(keys.at("albedo").at("anyOf").size() == 3); // a number, three, or a texture
    CHECK(keys.at("pair").at("maxItems") == 2);
    CHECK(!keys.at("pair").contains("default")); // "none" is for readers
    CHECK(keys.at("edges") == nlohmann::json{{"type", "array"}, {"minItems", 2}});
}

TEST_CASE("generated text replaces what stands between its marks, and nothing else") {
    const std::string text = "before\n<!-- generated: a -->\nold\n<!-- end -->\nafter <!-- end -->\n";
    CHECK(describe::withGenerated(text, "a", "new\n") ==
          "before\n<!-- generated: a -->\nnew\n<!-- end -->\nafter <!-- end -->\n");
    const auto missing = errorOf([&] { return describe::withGenerated(text, "b", "new\n"); });
    REQUIRE(missing.has_value());
    CHECK(missing->message().find("<!-- generated: b -->") != std::string::npos);
}

TEST_CASE("a definition of the schema is replaced, even if its texts contain braces") {
    const std::string schema =
        "{\n  \"$defs\": {\n    \"a\": {\"description\": \"} \\\" {\", \"b\": {}},\n    \"c\": {}\n  }\n}\n";
    CHECK(describe::withDefinition(schema, "a", "{1}") ==
          "{\n  \"$defs\": {\n    \"a\": {1},\n    \"c\": {}\n  }\n}\n");
    CHECK(errorOf([&] { return describe::withDefinition(schema, "d", "{}"); }).has_value());
}

TEST_CASE("a new definition gets a place before another one") {
    const std::string schema = "{\n  \"$defs\": {\n    \"a\": {},\n    \"c\": {}\n  }\n}\n";
    CHECK(describe::withPlaceFor(schema, "b", "c") ==
          "{\n  \"$defs\": {\n    \"a\": {},\n    \"b\": {},\n    \"c\": {}\n  }\n}\n");
    CHECK(describe::withPlaceFor(schema, "a", "c") == schema);
    CHECK(errorOf([&] { return describe::withPlaceFor(schema, "b", "d"); }).has_value());
}

TEST_CASE("types with the same keys share a definition") {
    const std::array<std::string_view, 2> types{"cells", "tiles"};
    const auto schema = nlohmann::json::parse(describe::definition({.type = "cells", .keys = {&kKeys[3], 1}}, types));
    CHECK(schema.at("properties").at("type") == nlohmann::json{{"enum", {"cells", "tiles"}}});
    CHECK(schema.at("properties").size() == 2);
}

TEST_CASE("a key alone is a definition, and a text may have a schema of its own") {
    CHECK(nlohmann::json::parse(describe::definition(kKeys[3])) ==
          nlohmann::json{{"type", "boolean"}, {"default", false}});
    const KeyDoc file{.name = "file", .type = KeyType::Text, .schema = R"({"type": "string", "minLength": 1})"};
    CHECK(nlohmann::json::parse(describe::definition(file)) == nlohmann::json{{"type", "string"}, {"minLength", 1}});
}

TEST_CASE("numbers are written as short as JSON allows") {
    CHECK(describe::shortNumber(1e-9) == "1e-9");
    CHECK(describe::shortNumber(-1e9) == "-1e9");
    CHECK(describe::shortNumber(1e30) == "1e30");
    CHECK(describe::shortNumber(0.25) == "0.25");
    CHECK(describe::shortNumber(4294967295) == "4294967295");
}
