// The contract of the BSDF models on the device, and each model against its twin: values, forward and reverse
// densities, and samples, for random pairs of directions.
#include "kernel/kernel_support.h"
#include "reference/bsdf/bsdf.h"
#include "unit/gpu/temporary_shaders.h"

namespace hyalite::testing {

namespace {

using glm::dvec2;

constexpr std::uint32_t kPairs = 4000; // for each model

struct Answer {
    vec3 fCos; // of wo and wi
    float pdfW;
    float reversePdfW;
    vec3 back; // f cos of the pair swapped, seen from wi's side
    float backPdfW;
    vec3 direction; // sampled for wo
    shared::uint through;
    vec3 weight;
    float samplePdfW;
    vec3 sampleFCos; // evaluated there
    float sampleWholePdfW;
    shared::uint flags;
};

struct EvaluateBsdfArguments {
    shared::MaterialArray materials;
    std::uint64_t answers = 0;
    std::uint32_t materialCount = 0;
    std::uint32_t count = 0;
};

constexpr const char* kKernel = R"(#version 460
#include "shared/kernel_arguments.h"
#include "bsdf/bsdf.glsl"
#include "lib/sampling.glsl"
#include "lib/thread.glsl"
struct Answer {
    vec3 fCos;
    float pdfW;
    float reversePdfW;
    vec3 back;
    float backPdfW;
    vec3 direction;
    uint through;
    vec3 weight;
    float samplePdfW;
    vec3 sampleFCos;
    float sampleWholePdfW;
    uint flags;
};
DEVICE_ARRAY(Answer, AnswerArray);
struct Arguments {
    MaterialArray materials;
    AnswerArray answers;
    uint materialCount;
    uint count;
};
layout(push_constant, scalar) uniform Push { Arguments args; };
void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    Sampler s = photonSampler(hash(i), 0u);
    MaterialRecord material = args.materials.at[i % args.materialCount];
    const vec3 up = vec3(0.0, 0.0, 1.0);
    vec3 wo = uniformSphere(sampleUnit(s, 0u));
    wo.z = abs(wo.z);
    vec3 wi = uniformSphere(sampleUnit(s, 1u));
    BsdfValue there = evaluateBsdf(material, true, up, up, wo, wi, kRadiance);
    bool above = wi.z > 0.0;
    vec3 normal = above ? up : -up;
    BsdfValue back = evaluateBsdf(material, above, normal, normal, wi, wo, kRadiance);
    BsdfSample next = sampleBsdf(material, true, up, up, wo, sampleUnit(s, 2u), sampleUnit(s, 3u).x, kRadiance);
    BsdfValue at = evaluateBsdf(material, true, up, up, wo, next.direction, kRadiance);
    args.answers.at[i] = Answer(there.fCos, there.pdfW, there.reversePdfW, back.fCos, back.pdfW, next.direction,
                                next.through ? 1u : 0u, next.weight, next.pdfW, at.fCos, at.pdfW, bsdfFlags(material));
}
)";

Scene everyModel() {
    Scene scene = reference::test::cornellBox();
    scene.objects.clear();
    scene.materials.clear();
    for (const MaterialModel& model : std::initializer_list<MaterialModel>{
             Diffuse{{0.8, 0.5, 0.2}}, Mirror{{0.9, 0.8, 0.7}}, Dielectric{1.5, 0}, Dielectric{1.5, 0.6},
             Dielectric{0.6, 0.7}, Conductor{{0.2, 0.9, 1.1}, {3.9, 2.4, 2.1}, 0},
             Conductor{{0.2, 0.9, 1.1}, {3.9, 2.4, 2.1}, 0.6}, MetallicRoughness{{0.8, 0.5, 0.2}, 0, 0},
             MetallicRoughness{{0.8, 0.5, 0.2}, 0.4, 0.6}, MetallicRoughness{{0.9, 0.7, 0.3}, 1, 0.7}}) {
        reference::test::addObject(scene, Sphere{}, reference::test::addMaterial(scene, model));
    }
    for (const double coatRoughness : {0.0, 0.5}) {
        MaterialModel lacquered = MetallicRoughness{{0.8, 0.2, 0.1}, 0.5, 0.7};
        lacquered.type = shared::kMaterialClearCoat;
        lacquered.coat = 0.8;
        lacquered.coatRoughness = coatRoughness;
        lacquered.coatIor = 1.6;
        reference::test::addObject(scene, Sphere{}, reference::test::addMaterial(scene, lacquered));
    }
    scene.lights = {{{0, 0, 5}, dvec3(1)}};
    return scene;
}

std::vector<Answer> answersOf(BothSides& both, std::uint32_t count) {
    const TemporaryShaders folder;
    folder.write("kernels/evaluate_bsdf.comp", kKernel);
    const gpu::Kernel kernel(both.device.context, both.device.tables, gpu::ShaderCompiler(folder.shaders()),
                             "evaluate_bsdf", both.deviceScene.specialization);
    const gpu::Array<Answer> answers(both.device.context, count, "answers");
    const EvaluateBsdfArguments arguments{.materials = both.deviceScene.materials,
                                          .answers = shared::ColorArray(answers).address,
                                          .materialCount = static_cast<std::uint32_t>(both.scene.materials.size()),
                                          .count = count};
    both.device.commands.run(kernel, arguments, count);
    both.device.commands.finish();
    return answers.read();
}

// Microfacet densities are fourth powers of cosines accurate to 2^-24, over squares of possibly small numbers.
bool near(double actual, double expected) {
    return std::abs(actual - expected) <= 2e-3 * std::abs(expected) + 2e-5;
}

bool near(const vec3& actual, const dvec3& expected) {
    return distance(actual, expected) <= 2e-3 * glm::length(expected) + 2e-5;
}

} // namespace

TEST_CASE("every BSDF keeps its contract on the device, and agrees with its twin") {
    BothSides both(everyModel());
    const auto kinds = static_cast<std::uint32_t>(both.scene.materials.size());
    const std::uint32_t count = kPairs * kinds;
    const std::vector<Answer> answers = answersOf(both, count);
    const reference::ShadingNormals up{{0, 0, 1}, {0, 0, 1}};
    std::vector<std::size_t> choices(kinds, 0); // of a part, within a rounding of its threshold
    std::vector<std::size_t> positive(kinds, 0);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Answer& a = answers[i];
        const MaterialModel& model = both.scene.materials[i % kinds].model;
        INFO("material " << i % kinds << ", pair " << i);
        const shared::Sampler s = shared::photonSampler(shared::hash(i), 0);
        dvec3 wo = reference::uniformSphere(reference::sampleUnitSquare(s, 0));
        wo.z = std::abs(wo.z);
        const dvec3 wi = reference::uniformSphere(reference::sampleUnitSquare(s, 1));
        REQUIRE(a.flags == reference::bsdfFlags(model));
        // The density of the pair swapped, as the device has it
        CHECK(near(a.reversePdfW, double{a.backPdfW}));
        // Reciprocity: f(wo -> wi) n_i^2 = f(wi -> wo) n_o^2
        const double index = wi.z < 0 ? model.ior : 1;
        CHECK(near(vec3(dvec3(a.fCos) * (index * index * std::abs(wo.z))), dvec3(a.back) * std::abs(wi.z)));
        const auto value = reference::evaluateBsdf(model, true, up, wo, wi, reference::Transport::Radiance);
        CHECK(near(a.fCos, value.f * std::abs(wi.z)));
        CHECK(near(a.pdfW, value.pdfW));
        CHECK(near(a.reversePdfW, value.reversePdfW));
        positive[i % kinds] += value.pdfW > 0 ? 1 : 0;
        const auto sample = reference::sampleBsdf(model, true, up, wo, reference::sampleUnitSquare(s, 2),
                                                  reference::sampleUnitSquare(s, 3).x, reference::Transport::Radiance);
        const bool isAbsorbed = a.weight == vec3(0);
        if (isAbsorbed != (!sample || sample->weight == dvec3(0)) ||
            (sample && !isAbsorbed && distance(a.direction, sample->direction) > 1e-2)) {
            ++choices[i % kinds];
            continue;
        }
        if (isAbsorbed) {
            continue;
        }
        CHECK((a.through != 0) == sample->through);
        CHECK(near(a.weight, sample->weight));
        CHECK(near(a.samplePdfW, sample->pdfW));
        const bool hasBoth = ((a.flags & shared::kBsdfDiffuse) != 0 && a.flags != shared::kBsdfDiffuse) ||
                             reference::coatOf(model).has_value();
        if (a.samplePdfW > 0 && !hasBoth) { // a single part, weighted by f cos / pdf
            CHECK(near(vec3(dvec3(a.weight) * double{a.samplePdfW}), dvec3(a.sampleFCos)));
            CHECK(near(a.samplePdfW, double{a.sampleWholePdfW}));
        }
    }
    for (std::uint32_t kind = 0; kind < kinds; ++kind) {
        INFO("material " << kind);
        const std::uint32_t flags = reference::bsdfFlags(both.scene.materials[kind].model);
        CHECK(choices[kind] <= kPairs / 500);
        CHECK((positive[kind] > 1000) == ((flags & (shared::kBsdfDiffuse | shared::kBsdfGlossy)) != 0));
    }
}

} // namespace hyalite::testing
