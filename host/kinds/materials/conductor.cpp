// Metal: shaders/bsdf/conductor.glsl, host/reference/bsdf/conductor.cpp.
#include "kinds/materials/material_kinds.h"

#include <array>

namespace hyalite::kinds {
namespace {

// Complex indices of refraction: measured spectra, averaged over the red, green and blue of linear sRGB.
constexpr std::array<Choice<Conductor>, 4> kMetals{{
    {"gold", {{0.143, 0.375, 1.442}, {3.983, 2.386, 1.603}}},
    {"silver", {{0.155, 0.117, 0.138}, {4.828, 3.122, 2.147}}},
    {"copper", {{0.200, 0.924, 1.102}, {3.913, 2.453, 2.142}}},
    {"aluminium", {{1.657, 0.880, 0.521}, {9.224, 6.270, 4.837}}},
}};
constexpr std::array kMetalNames{kMetals[0].name, kMetals[1].name, kMetals[2].name, kMetals[3].name};

constexpr KeyDoc kMetal{.name = "metal",
                        .type = KeyType::Word,
                        .text = "a metal with a known refractive index; otherwise give `eta` and `k`",
                        .words = kMetalNames};
constexpr KeyDoc kEta{
    .name = "eta", .type = KeyType::Color, .range = kIor, .text = "real part of the refractive index, relative to air"};
constexpr KeyDoc kExtinction{
    .name = "k", .type = KeyType::Color, .range = {0, 100}, .text = "imaginary part of the refractive index"};
constexpr KeyDoc kRoughness = roughnessKey("0: polished; above 0: brushed evenly");
constexpr std::array kKeys{kMetal, kEta, kExtinction, kRoughness};

constexpr std::string_view kRules = R"({"oneOf": [
        {"required": ["metal"], "properties": {"eta": false, "k": false}},
        {"required": ["eta", "k"], "properties": {"metal": false}}
      ]})";

MaterialModel read(Reader& reader, const Scene& /*scene*/, Material& /*has no textures*/) {
    Conductor conductor;
    if (const auto metal = reader.find(kMetal.name)) {
        conductor = choose<Conductor>(*metal, "metal", kMetals);
        for (const KeyDoc& index : {kEta, kExtinction}) {
            if (const auto value = reader.find(index.name)) {
                value->fail("'metal' and '" + std::string(index.name) + "' exclude each other",
                            "remove one of the two");
            }
        }
    } else {
        const auto eta = reader.find(kEta.name);
        const auto k = reader.find(kExtinction.name);
        if (!eta || !k) {
            reader.map().fail("a conductor needs a 'metal', or 'eta' and 'k'", "e.g. metal: gold");
        }
        eta->readColor(conductor.eta, kEta.range);
        k->readColor(conductor.k, kExtinction.range);
    }
    readKey(reader, kRoughness, conductor.roughness);
    return conductor;
}

void record(const MaterialModel& model, shared::MaterialRecord& r) {
    r.eta = model.eta;
    r.k = model.k;
    r.roughness = static_cast<float>(model.roughness);
}

} // namespace

constinit const MaterialKind kConductorMaterial{
    .doc = {.type = "conductor", .schemaName = "conductor", .keys = kKeys, .rules = kRules},
    .read = read,
    .record = record,
    .reference = &reference::kConductorBsdf};

} // namespace hyalite::kinds
