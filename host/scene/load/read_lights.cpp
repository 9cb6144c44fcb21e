// See read_lights.h. The known lights are the rows of kinds/lights/light_kinds.h.
#include "scene/load/read_lights.h"

#include "kinds/lights/light_kinds.h"

#include <vector>

namespace hyalite {

void readLight(const Value& value, const std::filesystem::path& folder, Scene& scene) {
    std::vector<Choice<const kinds::LightKind*>> choices;
    for (const kinds::LightKind* kind : kinds::kLightKinds) {
        if (kind->read != nullptr) {
            choices.push_back({kind->doc.type, kind});
        }
    }
    Reader reader(value);
    choose<const kinds::LightKind*>(reader.require("type"), "light type", choices)->read(reader, folder, scene);
    reader.finish();
}

} // namespace hyalite
