// The JSON schema and the tables of the documentation are what the program's rows say.
#include "describe/scene_format.h"
#include "scene/yaml/settings_table.h"
#include "unit/scene/scene_test_support.h"

#include <nlohmann/json.hpp>

using namespace hyalite;
using namespace hyalite::test;

namespace {

nlohmann::json settingsInSchema(Section section) {
    const nlohmann::json schema = nlohmann::json::parse(readFile(kSourceFolder / describe::kSchemaFile));
    return schema.at("$defs").at(std::string(nameOf(section))).at("properties");
}

} // namespace

TEST_CASE("the JSON schema and the tables of the scene format are up to date") {
    const std::string schema = readFile(kSourceFolder / describe::kSchemaFile);
    const std::string docs = readFile(kSourceFolder / describe::kDocsFile);
    INFO("to update " << describe::kSchemaFile << " and " << describe::kDocsFile << ": " << describe::kUpdateCommand);
    CHECK(describe::describedSchema(schema) == schema);
    CHECK(describe::describedDocs(docs) == docs);
}

TEST_CASE("the schema's default of each setting is what the program takes") {
    const Settings untouched;
    std::size_t compared = 0;
    for (const Setting& setting : settingsTable()) {
        INFO(dottedName(setting));
        const nlohmann::json key = settingsInSchema(setting.section).at(std::string(setting.doc.name));
        if (setting.doc.type == KeyType::Text || setting.doc.name == "focus_distance") {
            CHECK(!key.contains("default")); // none, or the distance of look_at
            continue;
        }
        const std::string text = setting.text(untouched);
        const nlohmann::json taken =
            setting.doc.type == KeyType::Word ? nlohmann::json(text) : nlohmann::json::parse(text);
        CHECK(key.at("default") == taken);
        ++compared;
    }
    CHECK(compared > 25);
}

TEST_CASE("the schema's depths are those of the integrators") {
    const nlohmann::json schema = nlohmann::json::parse(readFile(kSourceFolder / describe::kSchemaFile));
    const nlohmann::json render = schema.at("$defs").at("render");
    CHECK(render.at("then").at("properties").at("max_depth").at("maximum") ==
          depthRange(integratorNamed("whitted")).high);
    for (const char* integrator : {"ppm", "photonmap", "path"}) {
        CHECK(render.at("else").at("properties").at("max_depth").at("minimum") ==
              depthRange(integratorNamed(integrator)).low);
        CHECK(render.at("properties").at("max_depth").at("maximum") == depthRange(integrator).high);
    }
}
