#include "scene/yaml/photon_map_settings.h"

#include "scene/model/scene_limits.h"
#include "scene/yaml/custom_code.h"
#include "shaders/shared/limits.h"

#include <array>

namespace hyalite {
namespace {

constexpr Range kEmitted{0, kMostPhotons};
constexpr Range kNearest{2, shared::kMaxNearest}; // the farthest sets the radius and does not count
constexpr Range kSearchRadius{0, kLargestLength, true, true, "m"};
constexpr Range kConeConstant{1, 1000};
constexpr Range kGatherRays{0, 4096};
constexpr Range kAgreeing{0, 64};

constexpr std::array<Choice<PhotonStructure>, 2> kStructures{{
    {"kdtree", PhotonStructure::Tree},
    {"grid", PhotonStructure::Grid},
}};
constexpr std::array<Choice<PhotonFilter>, 4> kFilters{{
    {"none", PhotonFilter::None},
    {"cone", PhotonFilter::Cone},
    {"gaussian", PhotonFilter::Gaussian},
    {"custom", PhotonFilter::Custom},
}};
constexpr std::array<Choice<PhotonView>, 5> kViews{{
    {"picture", PhotonView::Picture},
    {"global_map", PhotonView::GlobalMap},
    {"caustic_map", PhotonView::CausticMap},
    {"photons", PhotonView::Photons},
    {"radius", PhotonView::Radius},
}};

template <class T, std::size_t n>
void optionalChoice(Reader& reader, std::string_view key, T& out, const std::array<Choice<T>, n>& choices) {
    if (const auto value = reader.find(key)) {
        out = choose<T>(*value, key, choices);
    }
}

} // namespace

void readPhotonMapSettings(Reader& reader, PhotonMapSettings& settings) {
    reader.optional("caustic_photons", settings.causticPhotons, kEmitted);
    reader.optional("projection_map", settings.projectionMap);
    optionalChoice(reader, "structure", settings.structure, kStructures);
    reader.optional("nearest", settings.nearest, kNearest);
    reader.optional("caustic_nearest", settings.causticNearest, kNearest);
    reader.optional("caustic_radius", settings.causticRadius, kSearchRadius);
    optionalChoice(reader, "filter", settings.filter, kFilters);
    optionalChoice(reader, "caustic_filter", settings.causticFilter, kFilters);
    reader.optional("cone_constant", settings.coneConstant, kConeConstant);
    reader.optional("differential_checking", settings.differentialChecking);
    reader.optional("gather_rays", settings.gatherRays, kGatherRays);
    reader.optional("precomputed_irradiance", settings.precomputedIrradiance);
    reader.optional("shadow_photons", settings.shadowPhotons, kAgreeing);
    optionalChoice(reader, "view", settings.view, kViews);
    if (const auto file = reader.find("filter_file")) {
        settings.customFilter = readCustomCode(*file, std::filesystem::path(file->file()).parent_path(), "float");
    }
    const bool isCustom = settings.filter == PhotonFilter::Custom || settings.causticFilter == PhotonFilter::Custom;
    if (isCustom && settings.customFilter == nullptr) {
        reader.map().fail("a custom filter needs its code", "name it: filter_file: falloff.glsl");
    }
    if (settings.causticRadius != 0 && settings.causticRadius < kSmallestLength) {
        reader.require("caustic_radius")
            .fail("'caustic_radius' must be 0 or at least " + numberText(kSmallestLength) + " m",
                  "0: 1/25 of the radius of the scene's bounding sphere");
    }
}

} // namespace hyalite
