// See settings_table.h.
#include "scene/yaml/settings_table.h"

#include "base/spelling.h"
#include "scene/model/scene_limits.h"
#include "scene/yaml/custom_code.h"
#include "shaders/shared/limits.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <type_traits>
#include <vector>

namespace hyalite {
namespace {

using Words = std::span<const std::string_view>;

// The word for each value of an enumeration, in the order of its values.
constexpr std::array<std::string_view, 2> kSamplers{"sobol", "independent"};
static_assert(static_cast<int>(RandomNumbers::Independent) == 1);
constexpr std::array<std::string_view, 2> kStructures{"kdtree", "grid"};
static_assert(static_cast<int>(PhotonStructure::Grid) == 1);
constexpr std::array<std::string_view, 4> kFilters{"none", "cone", "gaussian", "custom"};
static_assert(static_cast<int>(PhotonFilter::Custom) == 3);
constexpr std::array<std::string_view, 5> kViews{"picture", "global_map", "caustic_map", "photons", "radius"};
static_assert(static_cast<int>(PhotonView::Radius) == 4);

template <class Enum>
constexpr Words wordsOf() {
    if constexpr (std::is_same_v<Enum, RandomNumbers>) {
        return kSamplers;
    } else if constexpr (std::is_same_v<Enum, PhotonStructure>) {
        return kStructures;
    } else if constexpr (std::is_same_v<Enum, PhotonFilter>) {
        return kFilters;
    } else {
        static_assert(std::is_same_v<Enum, PhotonView>);
        return kViews;
    }
}

template <class T>
constexpr KeyType typeOf() {
    if constexpr (std::is_enum_v<T> || std::is_same_v<T, std::string>) {
        return KeyType::Word;
    } else if constexpr (std::is_same_v<T, double>) {
        return KeyType::Number;
    } else if constexpr (std::is_same_v<T, std::uint32_t>) {
        return KeyType::WholeNumber;
    } else if constexpr (std::is_same_v<T, bool>) {
        return KeyType::Flag;
    } else if constexpr (std::is_same_v<T, glm::dvec3>) {
        return KeyType::Vector;
    } else if constexpr (std::is_same_v<T, glm::uvec2>) {
        return KeyType::WholePair;
    } else {
        static_assert(std::is_same_v<T, std::shared_ptr<const CustomCode>>);
        return KeyType::Text;
    }
}

// ---- reading a value, by its type ----

// The value, which must be one of the row's words.
std::string wordOf(const Value& value, const KeyDoc& doc) {
    std::string word = value.text();
    if (std::ranges::find(doc.words, word) == doc.words.end()) {
        failUnknownWord(value, doc.name, std::vector<std::string>(doc.words.begin(), doc.words.end()));
    }
    return word;
}

template <class T>
void readValue(const Value& value, const KeyDoc& doc, T& out) {
    if constexpr (std::is_enum_v<T>) {
        out = static_cast<T>(std::ranges::find(doc.words, wordOf(value, doc)) - doc.words.begin());
    } else if constexpr (std::is_same_v<T, std::string>) {
        out = wordOf(value, doc);
    } else if constexpr (std::is_same_v<T, bool>) {
        value.read(out);
    } else if constexpr (std::is_same_v<T, std::shared_ptr<const CustomCode>>) {
        out = readCustomCode(value, std::filesystem::path(value.file()).parent_path(), "float");
    } else {
        value.read(out, doc.range);
    }
}

// ---- writing a value ----

template <class Number>
std::string numberAsText(Number value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return {digits.data(), end};
}

template <class T>
std::string valueAsText(const T& value) {
    if constexpr (std::is_enum_v<T>) {
        return std::string(wordsOf<T>()[static_cast<std::size_t>(value)]);
    } else if constexpr (std::is_same_v<T, std::string>) {
        return value;
    } else if constexpr (std::is_same_v<T, bool>) {
        return value ? "true" : "false";
    } else if constexpr (std::is_same_v<T, glm::dvec3>) {
        return '[' + numberAsText(value.x) + ", " + numberAsText(value.y) + ", " + numberAsText(value.z) + ']';
    } else if constexpr (std::is_same_v<T, glm::uvec2>) {
        return '[' + numberAsText(value.x) + ", " + numberAsText(value.y) + ']';
    } else if constexpr (std::is_same_v<T, std::shared_ptr<const CustomCode>>) {
        return value == nullptr ? std::string() : value->file;
    } else {
        return numberAsText(value);
    }
}

// ---- rows ----

// The row of one setting. `path` is a chain of pointers to members, from Settings to the setting.
template <auto... path>
Setting row(Setting setting) {
    using T = std::remove_cvref_t<decltype((std::declval<Settings&>().*....*path))>;
    setting.doc.type = typeOf<T>();
    if constexpr (std::is_enum_v<T>) {
        setting.doc.words = wordsOf<T>();
    }
    setting.read = [](const Value& value, const KeyDoc& doc, Settings& settings) {
        readValue(value, doc, (settings.*....*path));
    };
    setting.text = [](const Settings& settings) { return valueAsText((settings.*....*path)); };
    return setting;
}

template <auto member>
Setting camera(Setting setting) {
    setting.section = Section::Camera;
    return row<&Settings::camera, member>(setting);
}

template <auto member>
Setting render(const Setting& setting) {
    return row<&Settings::render, member>(setting);
}

template <auto member>
Setting photonMap(const Setting& setting) {
    return row<&Settings::render, &RenderSettings::photonMap, member>(setting);
}

constexpr double kMostWhole = std::numeric_limits<std::uint32_t>::max();
constexpr Range kCoordinate{-kLargestLength, kLargestLength, true, true, "m"};
constexpr Range kSearchRadius{
    .low = kSmallestLength, .high = kLargestLength, .unit = "m", .orZero = true}; // 0: automatic
constexpr Range kNearest{2, shared::kMaxNearest}; // the farthest photon only sets the radius; the estimate omits it
// A whitted ray after n reflections or refractions is segment n + 1 of its path; the segment counter has 8 bits.
constexpr Range kTreeDepth{0, shared::kMaxDepth - 1};
constexpr Range kPathDepth{1, shared::kMaxDepth};

std::vector<Setting> cameraRows() {
    return {
        camera<&Camera::position>({.doc = {.name = "position",
                                           .range = kCoordinate,
                                           .text = "centre of the lens; must differ from `look_at`"}}),
        camera<&Camera::lookAt>(
            {.doc = {.name = "look_at", .range = kCoordinate, .text = "point at the centre of the picture"}}),
        camera<&Camera::up>({.doc = {.name = "up",
                                     .range = {-kLargestLength, kLargestLength},
                                     .text = "up direction, of any length, not parallel to the view"}}),
        camera<&Camera::fov>(
            {.doc = {.name = "fov", .range = {0, 180, false, false, "degrees"}, .text = "vertical field of view"}}),
        camera<&Camera::aperture>({.doc = {.name = "aperture",
                                           .range = {0, kLargestLength, true, true, "m"},
                                           .text = "lens diameter; 0: a pinhole, everything is in focus"}}),
        camera<&Camera::focusDistance>(
            {.doc = {.name = "focus_distance",
                     .range = {kSmallestLength, kLargestLength, true, true, "m"},
                     .defaultText = "distance to `look_at`",
                     .text = "distance from `position` to the plane in focus, along the view"}}),
        camera<&Camera::resolution>(
            {.doc = {.name = "resolution",
                     .range = {1, kLargestSide, true, true, "pixels"},
                     .text = "width and height, at most 2^28 pixels in all; the command line also "
                             "accepts 640x480"},
             .option = "--resolution",
             .label = "Resolution"}),
    };
}

std::vector<Setting> renderRows() {
    return {
        render<&RenderSettings::integrator>({.doc = {.name = "integrator",
                                                     .text = "progressive photon mapping, Jensen's two-pass photon "
                                                             "mapping, recursive ray tracing or unbiased path tracing",
                                                     .words = kIntegratorNames},
                                             .option = "--integrator",
                                             .label = "Integrator"}),
        render<&RenderSettings::maxDepth>({.doc = {.name = "max_depth",
                                                   .range = {0, shared::kMaxDepth},
                                                   .text = "most segments of a path from light to eye; whitted: most "
                                                           "successive reflections and refractions",
                                                   .rangeText = "whitted [0, 254], others [1, 255]"},
                                           .option = "--max-depth",
                                           .label = "Longest path [segments]",
                                           .photons = PhotonsDepend::OnValue}),
        render<&RenderSettings::passes>(
            {.doc = {.name = "passes",
                     .range = {1, kMostWhole},
                     .text = "number of independent pictures to average; photonmap, path: samples per pixel"},
             .option = "--passes",
             .label = "Passes",
             .affectsPicture = false}),
        render<&RenderSettings::targetError>(
            {.doc = {.name = "target_error",
                     .range = {0, 1e9},
                     .text =
                         "stop as soon as the [estimated error](metrics.md#the-estimated-error) is at most this, or "
                         "after `passes` passes; 0: render all passes"},
             .option = "--target-error",
             .affectsPicture = false}),
        render<&RenderSettings::photons>(
            {.doc = {.name = "photons",
                     .range = {1, kMostPhotons},
                     .text = "photons emitted; ppm: per pass, for indirect light; photonmap: once, for the global map"},
             .option = "--photons",
             .label = "Photons",
             .photons = PhotonsDepend::OnValue}),
        render<&RenderSettings::seed>(
            {.doc = {.name = "seed",
                     .range = {0, kMostWhole},
                     .text = "seed of the random numbers; the same seed gives the same picture"},
             .option = "--seed",
             .label = "Seed",
             .photons = PhotonsDepend::OnValue}),
        render<&RenderSettings::sampler>(
            {.doc = {.name = "sampler",
                     .text = "low-discrepancy numbers, or pseudorandom numbers to measure what low discrepancy gains"},
             .option = "--sampler",
             .photons = PhotonsDepend::OnValue}),
        render<&RenderSettings::radius>(
            {.doc = {.name = "radius",
                     .range = kSearchRadius,
                     .text = "ppm: search radius of the first pass for photons of indirect light; 0: [from their "
                             "density](progressive.md#radii). photonmap: largest radius of an estimate; 0: "
                             "[from their density](photon-mapping.md#the-nearest-photons)"},
             .label = "Search radius [m], 0: automatic"}),
        render<&RenderSettings::alpha>(
            {.doc = {.name = "alpha",
                     .range = {0, 1, false, false},
                     .defaultText = "2/3",
                     .text = "fraction of the photons that a shrinking radius keeps; the nearer to "
                             "1, the more slowly it shrinks"},
             .label = "Alpha"}),
        render<&RenderSettings::minWeight>(
            {.doc = {.name = "min_weight",
                     .range = {0, 1},
                     .defaultText = "1/1024",
                     .text =
                         "rays that would add less than this fraction to their pixel are not traced; 0: trace all"}}),
    };
}

std::vector<Setting> photonMapRows() {
    return {
        photonMap<&PhotonMapSettings::causticPhotons>(
            {.doc = {.name = "caustic_photons",
                     .range = {0, kMostPhotons},
                     .text = "photons emitted towards mirrors and glass; ppm: per pass; 0: the other photons form "
                             "caustics. photonmap: for the caustic map; 0: no caustics"},
             .label = "Caustic photons",
             .photons = PhotonsDepend::OnValue}),
        photonMap<&PhotonMapSettings::projectionMap>(
            {.doc = {.name = "projection_map", .text = "aim the caustic photons at mirrors and glass"},
             .photons = PhotonsDepend::OnValue}),
        photonMap<&PhotonMapSettings::causticRadius>(
            {.doc = {.name = "caustic_radius",
                     .range = kSearchRadius,
                     .text =
                         "ppm: search radius of the first pass for caustic photons; 0: from their density. photonmap: "
                         "largest radius of an estimate from the caustic map; 0: from their density"}}),
        photonMap<&PhotonMapSettings::structure>(
            {.doc = {.name = "structure", .text = "data structure for photon lookups"}}),
        photonMap<&PhotonMapSettings::nearest>({.doc = {.name = "nearest",
                                                        .range = kNearest,
                                                        .text = "nearest photons in an estimate from the global map"},
                                                .label = "Photons per estimate"}),
        photonMap<&PhotonMapSettings::causticNearest>(
            {.doc = {.name = "caustic_nearest",
                     .range = kNearest,
                     .text = "nearest photons in an estimate from the caustic map"}}),
        photonMap<&PhotonMapSettings::gatherRays>(
            {.doc = {.name = "gather_rays",
                     .range = {0, 4096},
                     .text = "final-gather rays per sample; 0: read indirect light directly from the global map"},
             .label = "Final-gather rays"}),
        photonMap<&PhotonMapSettings::precomputedIrradiance>(
            {.doc = {.name = "precomputed_irradiance",
                     .text = "final gathering looks up irradiance precomputed at the photons"}}),
    };
}

std::vector<Setting> photonEstimateRows() {
    return {
        photonMap<&PhotonMapSettings::filter>(
            {.doc = {.name = "filter",
                     .text = "weight of a photon by its distance, in an estimate from the global map"}}),
        photonMap<&PhotonMapSettings::causticFilter>(
            {.doc = {.name = "caustic_filter",
                     .text = "weight of a photon by its distance, in an estimate from the caustic map"}}),
        // The hash of the shaders covers the file's content; its path does not matter.
        photonMap<&PhotonMapSettings::customFilter>(
            {.doc = {.name = "filter_file",
                     .defaultText = "none",
                     .text = "GLSL file of a `custom` filter, in the scene file's folder or below; see "
                             "[experiments](experiments.md)"},
             .affectsPicture = false}),
        photonMap<&PhotonMapSettings::coneConstant>({.doc = {.name = "cone_constant",
                                                             .range = {1, 1000},
                                                             .text = "k of the cone filter; large values flatten it"}}),
        photonMap<&PhotonMapSettings::differentialChecking>(
            {.doc = {.name = "differential_checking",
                     .text = "stop growing an estimate from the caustic map where it would blur an edge"}}),
        photonMap<&PhotonMapSettings::shadowPhotons>(
            {.doc = {.name = "shadow_photons",
                     .range = {0, 64},
                     .text = "number of agreeing direct or shadow photons that replace a shadow ray; 0: trace every "
                             "shadow ray"},
             .photons = PhotonsDepend::OnWhetherZero}),
        photonMap<&PhotonMapSettings::view>(
            {.doc = {.name = "view", .text = "what to render: the picture, or a view of the photon maps"}}),
    };
}

} // namespace

std::span<const Setting> settingsTable() {
    static const std::vector<Setting> table = [] {
        std::vector<Setting> rows;
        for (const auto& part : {cameraRows(), renderRows(), photonMapRows(), photonEstimateRows()}) {
            for (const Setting& setting : part) {
                rows.push_back(setting);
            }
        }
        return rows;
    }();
    return table;
}

std::string_view nameOf(Section section) {
    return section == Section::Camera ? "camera" : "render";
}

std::string dottedName(const Setting& setting) {
    return std::string(nameOf(setting.section)) + '.' + std::string(setting.doc.name);
}

std::string nameOf(RandomNumbers sampler) {
    return valueAsText(sampler);
}

const Range& depthRange(const IntegratorRow& integrator) {
    return integrator.cameraPaths.followsAllWays ? kTreeDepth : kPathDepth;
}

} // namespace hyalite
