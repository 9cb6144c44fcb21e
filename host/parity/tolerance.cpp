// The table of docs/parity.md.
#include "parity/tolerance.h"

#include <algorithm>
#include <array>

namespace hyalite::parity {

namespace {

// A tolerance and its reason.
struct Allowed {
    double relative;
    std::string_view reason;
};
constexpr Allowed kSame{0, "a copy: the same bits"};
constexpr Allowed kPosition{
    0x1p-18, "positions of curved and transformed shapes are right to 2^-20 of the coordinates that they "
             "are computed from (shapes/surface.glsl); the ray's way there, and the step off the surface, add "
             "as much each"};
constexpr Allowed kDirection{0x1p-20, "a dozen roundings of components below 1"};
constexpr Allowed kNormal{0x1p-14, "the position's error over the shape's radius: 2^-20 of the scene over 1/64 of it"};
constexpr Allowed kBounce{0x1p-13, "a bounce doubles the angle that the normal is wrong by"};
constexpr Allowed kSampled{
    0x1p-13,
    "the third component of a sampled direction is the root of a difference from 1, of which grazing directions "
    "keep half the digits"};
constexpr Allowed kWeight{0x1p-15,
                          "products of some dozens of terms, each right to 2^-24, and cosines that are right to the "
                          "direction's error"};
constexpr Allowed kDensity{0x1p-10,
                           "densities of microfacets: squares and fourth powers of cosines that are right to the "
                           "direction's error"};
constexpr Allowed kSide{0x1.2p-14, "octahedral, 16 bits a coordinate: half a step of 2/65535 in x and y is up to one "
                                   "in z, on a vector of length 1/sqrt(3) at least"};
constexpr Allowed kPhotonDirection{0x1.2p-13, "octahedral, 15 bits a coordinate"};
constexpr Allowed kPhotonNormal{
    0x1.12p-9, "octahedral, 11 bits a coordinate: half a step of 2/2047 in x and y is up to one in z, on a "
               "vector of length 1/sqrt(3) at least"};
constexpr Allowed kSum{0x1p-15,
                       "a sum of hundreds of positive terms in another order: each addition rounds by 2^-24 of the "
                       "sum"};
constexpr Allowed kDisc{0x1p-15,
                        "the distance to one photon: a difference of coordinates, over a disc that is a hundredth of "
                        "the scene"};
constexpr Allowed kMean{0x1p-20, "a dozen roundings of sums over layers, and of the difference of their means"};
constexpr Allowed kRounding{0x1p-22, "one operation, or two"};

// What rounding may decide otherwise.
constexpr std::string_view kEdge = "edge, silhouette, or surfaces in one place";
constexpr std::string_view kCoin = "coin at its threshold";
constexpr std::string_view kGrazing = "grazing or ill-conditioned";
constexpr std::string_view kRim = "photon on the rim of the disc";

constexpr Tolerance exact(std::string_view stage, std::string_view field, std::string_view nearby = {}) {
    return {stage, field, Measure::Exact, 0, Scale::Value, "integers and decisions are equal or not", nearby};
}
constexpr Tolerance real(std::string_view stage, std::string_view field, Measure measure, const Allowed& allowed,
                         Scale scale = Scale::Value, std::string_view nearby = kGrazing) {
    return {stage, field, measure, allowed.relative, scale, allowed.reason, nearby};
}
constexpr Tolerance place(std::string_view stage, std::string_view field) {
    return real(stage, field, Measure::Vector, kPosition, Scale::Scene);
}
constexpr Tolerance angle(std::string_view stage, std::string_view field, const Allowed& allowed = kDirection) {
    return real(stage, field, Measure::Direction, allowed, Scale::One);
}

// A path as it starts at the camera.
constexpr auto cameraRays(std::string_view stage) {
    return std::to_array<Tolerance>({
        exact(stage, "pixel"),
        exact(stage, "seed"),
        exact(stage, "medium"),
        real(stage, "beta", Measure::Vector, kSame),
        real(stage, "pdfW", Measure::Number, kSame),
        place(stage, "origin"),
        angle(stage, "direction"),
    });
}

// What a ray hits first.
constexpr auto closestHit(std::string_view stage) {
    return std::to_array<Tolerance>({
        exact(stage, "object", kEdge),
        exact(stage, "leaf", kEdge),
        exact(stage, "primitive", kEdge),
        real(stage, "t", Measure::Number, kPosition, Scale::Scene),
        place(stage, "place"),
    });
}

// What becomes of a camera path at its hit.
constexpr auto shading(std::string_view stage) {
    return std::to_array<Tolerance>({
        exact(stage, "visible", kCoin),
        exact(stage, "rough", kCoin),
        exact(stage, "next 1", kCoin),
        exact(stage, "next 2", kCoin),
        exact(stage, "next 1 through", kCoin),
        exact(stage, "next 1 moved off", kGrazing),
        exact(stage, "next 1 seed"),
        exact(stage, "next 1 medium"),
        exact(stage, "next 2 through", kCoin),
        exact(stage, "next 2 moved off", kGrazing),
        exact(stage, "next 2 seed"),
        exact(stage, "next 2 medium"),
        exact(stage, "visible moved off", kGrazing),
        exact(stage, "visible depth"),
        exact(stage, "visible seed"),
        exact(stage, "visible coat"),
        exact(stage, "rough seed"),
        real(stage, "emitted", Measure::Vector, kWeight),
        place(stage, "visible position"),
        angle(stage, "visible normal", kNormal),
        angle(stage, "visible side", kSide),
        real(stage, "visible f", Measure::Vector, kWeight),
        place(stage, "rough position"),
        angle(stage, "rough normal", kNormal),
        angle(stage, "rough wo"),
        real(stage, "rough beta", Measure::Vector, kWeight),
        real(stage, "rough eta", Measure::Number, kRounding, Scale::One),
        real(stage, "rough alpha", Measure::Number, kRounding, Scale::One),
        place(stage, "next 1 origin"),
        angle(stage, "next 1 direction", kBounce),
        real(stage, "next 1 beta", Measure::Vector, kWeight),
        real(stage, "next 1 pdfW", Measure::Number, kDensity, Scale::One),
        place(stage, "next 2 origin"),
        angle(stage, "next 2 direction", kBounce),
        real(stage, "next 2 beta", Measure::Vector, kWeight),
        real(stage, "next 2 pdfW", Measure::Number, kDensity, Scale::One),
    });
}

template <std::size_t... N>
constexpr auto joined(const std::array<Tolerance, N>&... parts) {
    std::array<Tolerance, (N + ...)> all{};
    auto end = all.begin();
    (..., (end = std::copy(parts.begin(), parts.end(), end)));
    return all;
}

constexpr auto kTable =
    joined(cameraRays("generate_camera_rays"), closestHit("trace_closest"), shading("shade_surface"),
           cameraRays("trace_whitted"), closestHit("trace_whitted"), shading("trace_whitted"),
           std::to_array<Tolerance>({
               exact("trace_whitted", "ray"),
               exact("trace_whitted", "path"),
               exact("trace_whitted", "lit", kEdge),
               real("trace_whitted", "light", Measure::Vector, kWeight),
               exact("sample_lights", "sampled", kGrazing),
               place("sample_lights", "origin"),
               angle("sample_lights", "direction", kBounce),
               real("sample_lights", "distance", Measure::Number, kPosition, Scale::Scene),
               real("sample_lights", "contribution", Measure::Vector, kWeight),
               exact("sample_rough_lights", "added", kEdge),
               real("sample_rough_lights", "direct", Measure::Vector, kDensity),
               exact("trace_shadow", "added", kEdge),
               real("trace_shadow", "direct", Measure::Vector, kRounding),
               exact("bounce_paths", "goes on", kCoin),
               exact("bounce_paths", "seed"),
               exact("bounce_paths", "pixel"),
               exact("bounce_paths", "medium"),
               exact("bounce_paths", "leaves"),
               place("bounce_paths", "origin"),
               angle("bounce_paths", "direction", kSampled),
               real("bounce_paths", "beta", Measure::Vector, kWeight),
               real("bounce_paths", "pdfW", Measure::Number, kSampled, Scale::One),
               exact("emit_photons", "light", kCoin),
               exact("emit_photons", "photon"),
               exact("emit_photons", "kind"),
               exact("emit_photons", "medium"),
               exact("emit_photons", "shines", kGrazing),
               place("emit_photons", "origin"),
               angle("emit_photons", "direction", kSampled),
               real("emit_photons", "power", Measure::Vector, kWeight),
               exact("emit_caustic_photons", "light", kCoin),
               exact("emit_caustic_photons", "photon"),
               exact("emit_caustic_photons", "kind"),
               exact("emit_caustic_photons", "medium"),
               exact("emit_caustic_photons", "shines", kGrazing),
               place("emit_caustic_photons", "origin"),
               angle("emit_caustic_photons", "direction", kSampled),
               real("emit_caustic_photons", "power", Measure::Vector, kWeight),
               exact("scatter_photon", "stored", kCoin),
               exact("scatter_photon", "kind"),
               exact("scatter_photon", "length"),
               exact("scatter_photon", "marked"),
               exact("scatter_photon", "goes on", kCoin),
               exact("scatter_photon", "through", kCoin),
               exact("scatter_photon", "moved off", kGrazing),
               exact("scatter_photon", "next kind", kCoin),
               exact("scatter_photon", "next photon"),
               exact("scatter_photon", "next light"),
               exact("scatter_photon", "next medium"),
               place("scatter_photon", "position"),
               angle("scatter_photon", "direction", kPhotonDirection),
               angle("scatter_photon", "normal", kPhotonNormal),
               real("scatter_photon", "power", Measure::Vector, kWeight),
               place("scatter_photon", "next origin"),
               angle("scatter_photon", "next direction", kBounce),
               real("scatter_photon", "next power", Measure::Vector, kWeight),
               real("scatter_photon", "account", Measure::Vector, kWeight),
               exact("cast_shadow_photons", "stored"),
               exact("cast_shadow_photons", "kind"),
               exact("cast_shadow_photons", "length"),
               exact("cast_shadow_photons", "marked"),
               exact("cast_shadow_photons", "goes on"),
               exact("cast_shadow_photons", "next kind"),
               place("cast_shadow_photons", "position"),
               angle("cast_shadow_photons", "direction", kPhotonDirection),
               angle("cast_shadow_photons", "normal", kPhotonNormal),
               real("cast_shadow_photons", "power", Measure::Vector, kWeight),
               place("cast_shadow_photons", "next origin"),
               angle("cast_shadow_photons", "next direction"),
               exact("scan_group", "sum"),
               exact("sum_chunks", "sum"),
               exact("scan_chunks", "sum"),
               exact("list_next_rays", "slot"),
               exact("compact_camera_paths", "ray"),
               exact("compact_camera_paths", "path"),
               exact("compact_photon_paths", "ray"),
               exact("compact_photon_paths", "path"),
               exact("count_cells", "count"),
               exact("count_cells", "ranks"),
               exact("fill_cells", "slot"),
               exact("order_cells", "slot"),
               exact("sort_photons", "photon"),
               exact("mark_photons", "mark"),
               exact("key_photons", "slot"),
               exact("key_photons", "number"),
               exact("key_photons", "keys"),
               exact("count_digits", "count"),
               exact("sort_digits", "photon"),
               exact("split_nodes", "node"),
               exact("split_nodes", "photon"),
               exact("count_sides", "count"),
               exact("part_sides", "photon"),
               exact("finish_subtrees", "node"),
               exact("place_photons", "slot"),
               exact("place_photons", "photon"),
               real("gather_radiance", "gathered", Measure::Vector, kSum, Scale::Value, kRim),
               real("estimate_radiance", "gathered", Measure::Vector, kSum, Scale::Value, kRim),
               real("estimate_radiance", "radius", Measure::Number, kDisc, Scale::Value, kRim),
               exact("begin_irradiance", "depth"),
               real("begin_irradiance", "position", Measure::Vector, kSame),
               angle("begin_irradiance", "normal"),
               angle("begin_irradiance", "side", kSide),
               real("begin_irradiance", "f", Measure::Vector, kSame),
               exact("store_irradiance", "surface"),
               exact("store_irradiance", "record"),
               real("look_up_irradiance", "gathered", Measure::Vector, kSum, Scale::Value, "two records equally near"),
               exact("classify_visibility", "lit", kRim),
               exact("classify_visibility", "shadowed", kRim),
               exact("skip_shadow_rays", "traced"),
               exact("skip_shadow_rays", "count"),
               real("skip_shadow_rays", "direct", Measure::Vector, kRounding),
               exact("start_gather_rays", "alive", kGrazing),
               exact("start_gather_rays", "seed"),
               place("start_gather_rays", "origin"),
               angle("start_gather_rays", "direction", kSampled),
               real("start_gather_rays", "beta", Measure::Vector, kWeight),
               exact("splat_photons", "count", "edge of a pixel or silhouette"),
               real("show_surface", "normal", Measure::Vector, kNormal, Scale::One),
               real("show_surface", "depth", Measure::Vector, kSame),
               real("sum_paths", "color", Measure::Vector, kSum),
               real("add_gathered_light", "color", Measure::Vector, kRounding),
               real("accumulate_film", "color", Measure::Vector, kRounding),
               real("resolve_film", "color", Measure::Vector, kRounding),
               real("estimate_error", "error", Measure::Vector, kMean),
               real("estimate_error", "sum", Measure::Number, kSum),
           }));

} // namespace

std::span<const Tolerance> tolerancesOf(std::string_view stage) {
    const auto first = std::ranges::find(kTable, stage, &Tolerance::stage); // a stage's fields stand together
    const auto last = std::find_if(first, kTable.end(), [&](const Tolerance& t) { return t.stage != stage; });
    return {first, last};
}

std::span<const Tolerance> allTolerances() {
    return kTable;
}

} // namespace hyalite::parity
