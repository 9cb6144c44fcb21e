#include "render/integrators/whitted/whitted.h"

#include "reference/integrators/whitted.h"
#include "scene/model/render_seed.h"

namespace hyalite::render {

namespace {

constexpr std::uint32_t kSlotsOfPath = 2; // for a reflected ray and a refracted one

} // namespace

IntegratorKind Whitted::kind() {
    return {.name = "whitted",
            .layers = [](const RenderSettings&) -> std::vector<LayerKind> { return {{"radiance"}}; },
            .make = makeIntegrator<Whitted>,
            .reference = reference::renderWhitted};
}

Whitted::Whitted(const IntegratorInput& input)
    : device_(input.device), scene_(input.scene), deviceScene_(input.deviceScene), film_(input.film),
      traceWhitted_(device_.kernel("trace_whitted", deviceScene_.specialization)),
      sumPaths_(device_.kernel("sum_paths")), nextRays_(device_), roughLight_(device_, deviceScene_),
      radiance_(device_.context, film_.pixelCount(), "radiance") {}

Whitted::Level& Whitted::levelFor(std::uint32_t depth, std::uint32_t count) {
    Level& level = levels_.at(depth % 2);
    if (level.capacity() < count) {
        // Kept for the passes to come, whose levels are of much the same size; the first has a ray per pixel in each
        const std::uint32_t capacity = depth == 1 ? count : count + count / 4;
        const gpu::Context& context = device_.context;
        device_.commands.finish(); // what was recorded may use those that are replaced
        level = {};
        level = {.slots = {context, capacity, "slots of rays"},
                 .nextRays = {context, std::size_t{kSlotsOfPath} * capacity, "next rays"},
                 .nextPaths = {context, std::size_t{kSlotsOfPath} * capacity, "next camera paths"},
                 .alive = {context, capacity, "next rays alive"},
                 .pixels = {context, capacity, "pixels of rays"},
                 .light = {context, capacity, "light of a level"},
                 .roughPoints = {context, roughLight_.points(capacity), "rough points"}};
    }
    return level;
}

void Whitted::keepFor(std::uint32_t count) {
    if (kept_.rays.count() < count) {
        const gpu::Context& context = device_.context;
        kept_ = {.rays = {context, count, "kept rays"},
                 .paths = {context, count, "kept camera paths"},
                 .hits = {context, count, "kept hits"},
                 .emitted = {context, count, "kept emission"},
                 .visiblePoints = {context, count, "kept visible points"}};
    }
}

void Whitted::renderPass(std::uint32_t pass) {
    // One level of every pixel's tree of rays at a time
    std::uint32_t count = film_.pixelCount();
    levelFor(1, count);
    for (std::uint32_t depth = 1; count > 0; ++depth) {
        trace(pass, depth, count);
        const Level& level = levels_.at(depth % 2);
        if (depth > 1) { // the rays of a pixel stand together, so that their sum has one order
            device_.commands.run(
                sumPaths_,
                shared::SumPathsArguments{
                    .pixels = level.pixels, .light = level.light, .radiance = radiance_, .count = count},
                count);
        }
        const std::uint32_t alive = nextRays_.count(device_, level.alive, count);
        if (alive > 0) {
            nextRays_.list(device_, level.alive, count, kSlotsOfPath, levelFor(depth + 1, alive).slots);
        }
        count = alive;
    }
    film_.add(device_, 0, radiance_);
    device_.commands.finish();
}

void Whitted::trace(std::uint32_t pass, std::uint32_t depth, std::uint32_t count) {
    const bool keeps = device_.commands.areBuffersRead();
    if (keeps) {
        keepFor(count);
    }
    const Level& level = levels_.at(depth % 2);
    const Level& before = levels_.at((depth + 1) % 2);
    const bool fromCamera = depth == 1;
    const gpu::Array<glm::vec3>& light = fromCamera ? radiance_ : level.light;
    device_.commands.run(traceWhitted_,
                         shared::TraceWhittedArguments{.slots = level.slots,
                                                       .rays = before.nextRays,
                                                       .paths = before.nextPaths,
                                                       .materials = deviceScene_.materials,
                                                       .lights = deviceScene_.lights,
                                                       .normals = deviceScene_.normals,
                                                       .instances = deviceScene_.instances,
                                                       .light = light,
                                                       .pixels = level.pixels,
                                                       .roughPoints = level.roughPoints,
                                                       .nextRays = level.nextRays,
                                                       .nextPaths = level.nextPaths,
                                                       .alive = level.alive,
                                                       .seed = renderSeed(scene_.render),
                                                       .camera = deviceScene_.camera,
                                                       .count = count,
                                                       .fromCamera = fromCamera ? 1U : 0U,
                                                       .depth = depth,
                                                       // The camera ray itself is neither reflection nor refraction
                                                       .maxDepth = scene_.render.maxDepth + 1,
                                                       .pass = pass,
                                                       .minWeight = static_cast<float>(scene_.render.minWeight),
                                                       .lightCount = deviceScene_.lightCount,
                                                       .rootNode = deviceScene_.rootNode,
                                                       .keeps = keeps ? 1U : 0U,
                                                       .keptRays = kept_.rays,
                                                       .keptPaths = kept_.paths,
                                                       .hits = kept_.hits,
                                                       .emitted = kept_.emitted,
                                                       .visiblePoints = kept_.visiblePoints},
                         count);
    counts_[Counter::CameraRays] += count;
    counts_[Counter::ShadowRays] += std::uint64_t{count} * deviceScene_.lightCount;
    for (std::uint32_t lamp = 0; lamp < deviceScene_.lightCount; ++lamp) {
        counts_[Counter::ShadowRays] += roughLight_.sample(level.roughPoints, light, count, lamp, pass);
    }
}

} // namespace hyalite::render
