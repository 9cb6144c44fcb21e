// The contract of every model of shaders/shared/materials.h: forward and reverse densities, reciprocity, sample weights
// of f cos / pdf, correct flags.
#include "reference/bsdf/bsdf.h"
#include "scene/model/code_twin.h"
#include "unit/reference/support.h"

#include <cmath>
#include <numbers>
#include <vector>

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;
using glm::dvec4;

namespace {

using std::numbers::pi;

const ShadingNormals kUp{{0, 0, 1}, {0, 0, 1}};
const ShadingNormals kDown{{0, 0, -1}, {0, 0, -1}};

struct Modelled {
    std::string name;
    MaterialModel model;
};

// A film by a function of the scene's own, whose twin this is: Schlick's approximation of three colours.
dvec3 film(double cosine, const dvec4& parameters) {
    return dvec3(parameters) + (1.0 - dvec3(parameters)) * std::pow(1 - cosine, 5);
}

MaterialModel filmOf(double roughness) {
    CustomCode code{.function = "film", .file = {}, .text = {}};
    code.twin = std::make_shared<const CodeTwin>(CodeTwin{.reflectance = film});
    return CustomReflectance{.code = std::make_shared<const CustomCode>(std::move(code)),
                             .parameters = {0.1, 0.4, 0.7, 0},
                             .roughness = roughness};
}

MaterialModel coated(const MetallicRoughness& base, double roughness, double ior, double coat = 1) {
    MaterialModel model = base;
    model.type = shared::kMaterialClearCoat;
    model.coat = coat;
    model.coatRoughness = roughness;
    model.coatIor = ior;
    return model;
}

const std::vector<Modelled>& models() {
    static const std::vector<Modelled> all{
        {"diffuse", Diffuse{{0.8, 0.5, 0.2}}},
        {"mirror", Mirror{{0.9, 0.8, 0.7}}},
        {"clear glass", Dielectric{1.5, 0}},
        {"frosted glass", Dielectric{1.5, 0.6}},
        {"frosted bubble", Dielectric{0.6, 0.7}},
        {"polished copper", Conductor{{0.2, 0.9, 1.1}, {3.9, 2.4, 2.1}, 0}},
        {"brushed copper", Conductor{{0.2, 0.9, 1.1}, {3.9, 2.4, 2.1}, 0.6}},
        {"lacquer", MetallicRoughness{{0.8, 0.5, 0.2}, 0, 0}},
        {"matt lacquer", MetallicRoughness{{0.8, 0.5, 0.2}, 0.4, 0.6}},
        {"rough gold", MetallicRoughness{{0.9, 0.7, 0.3}, 1, 0.7}},
        {"film", filmOf(0.5)},
        {"car paint", coated({{0.8, 0.1, 0.1}, 0.5, 0.6}, 0, 1.5)},
        {"worn car paint", coated({{0.8, 0.1, 0.1}, 0.5, 0.6}, 0.4, 1.5, 0.7)},
        {"varnished gold", coated({{0.9, 0.7, 0.3}, 1, 0.7}, 0.5, 1.8)},
    };
    return all;
}

bool has(const MaterialModel& model, std::uint32_t flags) {
    return (bsdfFlags(model) & flags) == flags;
}

dvec3 upward(Random& random) {
    dvec3 w = random.direction();
    w.z = std::abs(w.z);
    return w;
}

// The pair seen from wi's side, with the roles of the directions exchanged.
BsdfValue swapped(const MaterialModel& model, const dvec3& wo, const dvec3& wi, Transport transport) {
    const bool isAbove = wi.z > 0;
    return evaluateBsdf(model, isAbove, isAbove ? kUp : kDown, wi, wo, transport);
}

} // namespace

TEST_CASE("the reverse density of a pair of directions is the density of the swapped pair, and vice versa") {
    Random random;
    for (const auto& [name, model] : models()) {
        INFO(name);
        int positive = 0;
        for (int i = 0; i < 2000; ++i) {
            const dvec3 wo = upward(random);
            const dvec3 wi = random.direction();
            const BsdfValue there = evaluateBsdf(model, true, kUp, wo, wi, Transport::Radiance);
            const BsdfValue back = swapped(model, wo, wi, Transport::Radiance);
            CHECK_THAT(there.reversePdfW, WithinRel(back.pdfW, 1e-9) || WithinAbs(back.pdfW, 1e-12));
            CHECK_THAT(there.pdfW, WithinRel(back.reversePdfW, 1e-9) || WithinAbs(back.reversePdfW, 1e-12));
            positive += there.reversePdfW > 0 ? 1 : 0;
        }
        // Some of them, unless all of the surface is smooth
        CHECK((positive > 100) == (has(model, shared::kBsdfDiffuse) || has(model, shared::kBsdfGlossy)));
    }
}

TEST_CASE("f is the same with its directions swapped, across a boundary over the squared index") {
    // For radiance f(wo -> wi) n_i^2 = f(wi -> wo) n_o^2; a path that carries flux has the factor on the other side
    Random random;
    for (const auto& [name, model] : models()) {
        INFO(name);
        int across = 0;
        for (int i = 0; i < 2000; ++i) {
            const dvec3 wo = upward(random);
            const dvec3 wi = random.direction();
            const dvec3 there = evaluateBsdf(model, true, kUp, wo, wi, Transport::Radiance).f;
            const double scale = wi.z < 0 ? model.ior * model.ior : 1; // index there over index here
            const dvec3 back = swapped(model, wo, wi, Transport::Radiance).f;
            checkNear(there * scale, back, 1e-9 * (1 + glm::length(back)));
            const dvec3 flux = swapped(model, wo, wi, Transport::Flux).f;
            checkNear(there * scale, flux * (wi.z < 0 ? scale : 1), 1e-9 * (1 + glm::length(flux)) * scale);
            across += wi.z < 0 && there.x > 0 ? 1 : 0;
        }
        CHECK((across > 100) == has(model, shared::kBsdfTransmitting | shared::kBsdfGlossy));
    }
}

TEST_CASE("the density of a whole BSDF integrates to the share that is not absorbed, but for its smooth lobes") {
    // Midpoints of 400 x 400 cells of equal solid angle, against samples counted: a sample of a density, absorbed or
    // not
    for (const auto& [name, model] : models()) {
        for (const double angle : {0.0, 0.7, 1.2}) {
            INFO(name << " at " << angle);
            const dvec3 wo(std::sin(angle), 0, std::cos(angle));
            constexpr int kRows = 400; // midpoints in both angles
            constexpr int kColumns = 200;
            double integral = 0;
            for (int i = 0; i < kRows * kColumns; ++i) {
                const int row = i / kColumns;
                const double theta = pi * (row + 0.5) / kRows;
                const double phi = 2 * pi * (i % kColumns + 0.5) / kColumns;
                const dvec3 wi(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
                integral += std::sin(theta) * evaluateBsdf(model, true, kUp, wo, wi, Transport::Radiance).pdfW;
            }
            integral *= 2 * pi * pi / (kRows * kColumns);
            Random random;
            constexpr int kSide = 100;
            double kept = 0;
            for (int i = 0; i < kSide * kSide; ++i) {
                const int row = i / kSide;
                const dvec2 uv((i % kSide + random.unit()) / kSide, (row + random.unit()) / kSide);
                const auto sample = sampleBsdf(model, true, kUp, wo, uv, random.unit(), Transport::Radiance);
                kept += sample && sample->pdfW > 0 ? 1 : 0;
            }
            kept /= kSide * kSide;
            // Independent choices of part: standard deviation at most 0.005; the quadrature is right to 0.003
            CHECK_THAT(integral, WithinAbs(kept, 0.025));
            CHECK(integral < 1.003);
        }
    }
}

TEST_CASE("a sample has weight f cos / pdf of its part, and smooth lobes have no density") {
    Random random;
    for (const auto& [name, model] : models()) {
        INFO(name);
        const std::optional<Lobe> lobe = lobeOf(model, true);
        bool transmits = false;
        for (int i = 0; i < 1000; ++i) {
            const dvec3 wo = upward(random);
            const dvec2 uv(random.unit(), random.unit());
            const auto sample = sampleBsdf(model, true, kUp, wo, uv, random.unit(), Transport::Radiance);
            if (!sample) {
                continue;
            }
            transmits = transmits || sample->through;
            CHECK(sample->through == (sample->direction.z < 0));
            const double cosine = std::abs(sample->direction.z);
            const BsdfValue whole = evaluateBsdf(model, true, kUp, wo, sample->direction, Transport::Radiance);
            if (sample->pdfW == 0) {
                CHECK(has(model, shared::kBsdfSpecular));
                continue;
            }
            // Of one part, or of all of them where there is but one
            const bool isOnly = !lobe || (!has(model, shared::kBsdfDiffuse) && !coatOf(model));
            CHECK(sample->pdfW <= whole.pdfW * (1 + 1e-9));
            const dvec3 fCos = sample->weight * sample->pdfW;
            if (isOnly) {
                checkNear(fCos, whole.f * cosine, 1e-9 * (1 + glm::length(fCos)));
                CHECK_THAT(sample->pdfW, WithinRel(whole.pdfW, 1e-9));
            } else {
                CHECK(glm::all(glm::lessThanEqual(fCos, (whole.f * cosine) * (1 + 1e-9) + 1e-12)));
            }
        }
        CHECK(transmits == has(model, shared::kBsdfTransmitting));
    }
}

TEST_CASE("no model reflects or transmits more flux than arrives, and its mean weight is its albedo") {
    Random random;
    for (const auto& [name, model] : models()) {
        for (const double angle : {0.0, 0.7, 1.4}) {
            INFO(name << " at " << angle);
            const dvec3 wo(std::sin(angle), 0, std::cos(angle));
            constexpr int kSide = 60;
            dvec3 sum(0);
            for (int i = 0; i < kSide * kSide; ++i) {
                const int row = i / kSide;
                const dvec2 uv((i % kSide + random.unit()) / kSide, (row + random.unit()) / kSide);
                const auto sample = sampleBsdf(model, true, kUp, wo, uv, random.unit(), Transport::Flux);
                sum += sample ? sample->weight / double(kSide * kSide) : dvec3(0);
            }
            CHECK(glm::all(glm::lessThan(sum, dvec3(1.02)))); // 3600 samples of weights below 2
        }
    }
}

TEST_CASE("a clear coat of index 1, or one that covers nothing, leaves its base as it was") {
    Random random;
    const MetallicRoughness base{{0.8, 0.5, 0.2}, 0.4, 0.5};
    for (const MaterialModel& model : {coated(base, 0, 1), coated(base, 0.6, 1), coated(base, 0.6, 1.5, 0)}) {
        for (int i = 0; i < 1000; ++i) {
            const dvec3 wo = upward(random);
            const dvec3 wi = upward(random);
            const BsdfValue bare = evaluateBsdf(base, true, kUp, wo, wi, Transport::Radiance);
            const BsdfValue value = evaluateBsdf(model, true, kUp, wo, wi, Transport::Radiance);
            checkNear(value.f, bare.f, 1e-9 * (1 + glm::length(bare.f)));
            CHECK_THAT(value.pdfW, WithinRel(bare.pdfW, 1e-9));
        }
    }
}

TEST_CASE("a coat of glass over a perfect mirror reflects F and lets T in and out") {
    // Of light at an angle F is reflected, (1 - F)^2 goes in and out: 1 - F + F^2 in all, at normal incidence with
    // F = (0.5 / 2.5)^2 = 0.04: 0.9616
    const MaterialModel model = coated({dvec3(1), 1, 0}, 0, 1.5);
    Random random;
    for (const double angle : {0.0, 0.8, 1.3}) {
        const dvec3 wo(std::sin(angle), 0, std::cos(angle));
        const double inside = std::sqrt(1 - std::pow(std::sin(angle) / 1.5, 2));
        const double across = (wo.z - 1.5 * inside) / (wo.z + 1.5 * inside);
        const double along = (1.5 * wo.z - inside) / (1.5 * wo.z + inside);
        const double F = (across * across + along * along) / 2;
        double mean = 0;
        constexpr int kSteps = 1000; // of the number that picks the lobe: weights are right to their steps
        for (int i = 0; i < kSteps; ++i) {
            const auto sample = sampleBsdf(model, true, kUp, wo, {0.5, 0.5}, (i + 0.5) / kSteps, Transport::Flux);
            mean += sample.value().weight.x / kSteps;
        }
        CHECK_THAT(mean, WithinAbs(1 - F + F * F, 2e-3));
    }
}

TEST_CASE("no coat makes a white base reflect more light than it receives") {
    Random random;
    for (const double metallic : {0.0, 1.0}) {
        for (const double roughness : {0.0, 0.2, 0.5, 1.0}) {
            for (const double ior : {1.0, 1.5, 2.5}) {
                const MaterialModel model = coated({dvec3(1), metallic, 0.4}, roughness, ior);
                for (const double angle : {0.0, 0.6, 1.1, 1.45}) {
                    const dvec3 wo(std::sin(angle), 0, std::cos(angle));
                    constexpr int kSide = 60;
                    double sum = 0;
                    for (int i = 0; i < kSide * kSide; ++i) {
                        const int row = i / kSide;
                        const dvec2 uv((i % kSide + random.unit()) / kSide, (row + random.unit()) / kSide);
                        const auto sample = sampleBsdf(model, true, kUp, wo, uv, random.unit(), Transport::Flux);
                        sum += sample ? sample->weight.x / (kSide * kSide) : 0;
                    }
                    INFO("metallic " << metallic << ", coat " << roughness << ", index " << ior << ", " << angle);
                    // Weights spread by less than 0.5: the mean of 3600 by 0.008
                    CHECK(sum < 1.03);
                    CHECK(sum > 0.2);
                }
            }
        }
    }
}
