// See scene_format.h.
#include "describe/scene_format.h"

#include "describe/generated_parts.h"
#include "describe/key_text.h"
#include "describe/kinds_format.h"
#include "scene/yaml/settings_table.h"

#include <deque>
#include <utility>
#include <vector>

namespace hyalite::describe {
namespace {

// The rows of a section of settings. The default of a key is the struct's initial value, unless the row has a text.
struct SectionKeys {
    std::vector<KeyDoc> keys;
    std::vector<std::string> integrators; // for each key, the integrators that read it
    std::deque<std::string> defaults;     // storage that `keys` refer to

    explicit SectionKeys(Section section) {
        const Settings untouched;
        for (const Setting& setting : settingsTable()) {
            if (setting.section != section) {
                continue;
            }
            keys.push_back(setting.doc);
            if (setting.doc.defaultText.empty()) {
                defaults.push_back(setting.text(untouched));
                keys.back().defaultText = defaults.back();
            }
            integrators.push_back(readersText(setting));
        }
    }

    [[nodiscard]] static std::string readersText(const Setting& setting) {
        std::string names;
        for (const std::string& name : readersOf(setting.doc.name)) {
            names += (names.empty() ? "" : ", ") + name;
        }
        return names.empty() ? "all" : names;
    }
};

// The rules for max_depth by integrator. Without `integrator`, the default one counts a path's segments.
std::string depthRules() {
    std::string trees;
    for (const IntegratorRow& row : kIntegrators) {
        if (row.cameraPaths.followsAllWays) {
            trees += (trees.empty() ? "\"" : ", \"") + std::string(row.name) + '"';
        }
    }
    const IntegratorRow ofTrees{.name = {}, .text = {}, .cameraPaths = {.followsAllWays = true}};
    const IntegratorRow ofPaths{.name = {}, .text = {}};
    return R"({"if": {"properties": {"integrator": {"enum": [)" + trees + R"(]}}, "required": ["integrator"]},
      "then": {"properties": {"max_depth": {"maximum": )" +
           shortNumber(depthRange(ofTrees).high) + R"(}}},
      "else": {"properties": {"max_depth": {"minimum": )" +
           shortNumber(depthRange(ofPaths).low) + "}}}}";
}

} // namespace

std::string describedSchema(std::string schema) {
    const SectionKeys camera(Section::Camera);
    const SectionKeys render(Section::Render);
    const std::string rules = depthRules();
    schema = withDefinition(schemaWithKinds(std::move(schema)), "camera", definition({.keys = camera.keys}));
    return withDefinition(schema, "render", definition({.keys = render.keys, .rules = rules}));
}

std::string describedDocs(std::string markdown) {
    const SectionKeys camera(Section::Camera);
    const SectionKeys render(Section::Render);
    markdown = withGenerated(docsWithKinds(std::move(markdown)), "camera", keyTable(camera.keys));
    return withGenerated(markdown, "render", keyTable(render.keys, "integrators", render.integrators));
}

} // namespace hyalite::describe
