#include "render/integrators/whitted/whitted.h"

#include "reference/integrators/whitted.h"
#include "scene/model/render_seed.h"

namespace hyalite::render {

namespace {

constexpr std::uint32_t kSlotsOfPath = 2; // for a reflected ray and a refracted one

// The camera ray itself is neither a reflection nor a refraction.
std::uint32_t levelsOf(const Scene& scene) {
    return scene.render.maxDepth + 1;
}

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
      sumPaths_(device_.kernel("sum_paths")), nextRays_(device_),
      sizes_(device_.context, levelsOf(scene_) + 1, "levels"), roughLight_(device_, deviceScene_),
      shadowRays_(device_.context, "count of shadow rays"), radiance_(device_.context, film_.pixelCount(), "radiance") {
}

Whitted::Level& Whitted::levelFor(std::uint32_t depth, std::uint32_t count) {
    Level& level = levels_.at(depth % 2);
    if (level.capacity() < count) {
        // Kept for later passes, whose levels have nearly the same size; the first level always has one ray per pixel
        const std::uint32_t capacity = depth == 1 ? count : count + count / 4;
        const gpu::Context& context = device_.context;
        device_.commands.finish(); // recorded commands may use the buffers that are replaced
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
    const std::uint64_t shadowRaysBefore = shadowRays_.read();
    const bool isFirst = levels_[1].capacity() == 0;
    levelFor(1, film_.pixelCount());
    std::vector<std::uint32_t> rays = traceTrees(pass, isFirst || device_.commands.runsOneByOne());
    if (!hadRoom(rays)) { // more rays than in earlier passes: repeat, level by level
        shadowRays_.set(shadowRaysBefore);
        rays = traceTrees(pass, /*waits*/ true);
    }
    film_.add(device_, 0, radiance_);
    device_.commands.finish();
    for (const std::uint32_t ofLevel : rays) {
        counts_[Counter::CameraRays] += ofLevel;
    }
    counts_[Counter::ShadowRays] = shadowRays_.read();
}

std::vector<std::uint32_t> Whitted::traceTrees(std::uint32_t pass, bool waits) {
    // Traces one level of every pixel's ray tree at a time
    sizes_.begin(device_, film_.pixelCount());
    std::uint32_t traced = 0;
    for (std::uint32_t depth = 1; depth <= levelsOf(scene_); ++depth) {
        if (((waits && depth > 1) || looksAtQueue(device_, depth)) && sizes_.read(device_).count == 0) {
            break;
        }
        trace(pass, depth);
        if (depth > 1) { // the rays of a pixel are contiguous, so that their sum has a fixed order
            const Level& level = levels_.at(depth % 2);
            const gpu::ThreadCount threads = sizes_.threads();
            device_.commands.run(sumPaths_,
                                 shared::SumPathsArguments{.pixels = level.pixels,
                                                           .light = level.light,
                                                           .radiance = radiance_,
                                                           .count = threads.most(),
                                                           .live = threads.live()},
                                 threads);
        }
        ++traced;
        listNext(depth, waits);
    }
    device_.commands.finish();
    return sizes_.counts(traced);
}

void Whitted::listNext(std::uint32_t depth, bool waits) {
    const gpu::Array<shared::uint>& alive = levels_.at(depth % 2).alive;
    nextRays_.count(device_, alive, sizes_);
    if (waits) {
        device_.commands.finish();
        levelFor(depth + 1, sizes_.readNext().count);
    }
    const Level& next = levels_.at((depth + 1) % 2);
    nextRays_.list(device_, alive, sizes_, kSlotsOfPath, next.slots);
    sizes_.advance(next.capacity());
}

bool Whitted::hadRoom(const std::vector<std::uint32_t>& rays) const {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (rays[i] > levels_.at((i + 1) % 2).capacity()) {
            return false;
        }
    }
    return true;
}

void Whitted::trace(std::uint32_t pass, std::uint32_t depth) {
    const gpu::ThreadCount threads = sizes_.threads();
    const bool keeps = device_.commands.areBuffersRead();
    if (keeps) {
        keepFor(threads.most());
    }
    const Level& level = levels_.at(depth % 2);
    const Level& before = levels_.at((depth + 1) % 2);
    const bool fromCamera = depth == 1;
    const gpu::Array<glm::vec3>& lightOfLevel = fromCamera ? radiance_ : level.light;
    device_.commands.run(traceWhitted_,
                         shared::TraceWhittedArguments{.slots = fromCamera ? shared::UintArray{} : level.slots,
                                                       .rays = before.nextRays,
                                                       .paths = before.nextPaths,
                                                       .materials = deviceScene_.materials,
                                                       .lights = deviceScene_.lights,
                                                       .normals = deviceScene_.normals,
                                                       .instances = deviceScene_.instances,
                                                       .light = lightOfLevel,
                                                       .pixels = level.pixels,
                                                       .roughPoints = level.roughPoints,
                                                       .nextRays = level.nextRays,
                                                       .nextPaths = level.nextPaths,
                                                       .alive = level.alive,
                                                       .seed = renderSeed(scene_.render),
                                                       .camera = deviceScene_.camera,
                                                       .count = threads.most(),
                                                       .depths = depth + shared::kDepthsUnit * levelsOf(scene_),
                                                       .pass = pass,
                                                       .minWeight = static_cast<float>(scene_.render.minWeight),
                                                       .lightCount = deviceScene_.lightCount,
                                                       .rootNode = deviceScene_.rootNode,
                                                       .keptRays = keeps ? kept_.rays : shared::RayArray{},
                                                       .keptPaths = kept_.paths,
                                                       .hits = kept_.hits,
                                                       .emitted = kept_.emitted,
                                                       .visiblePoints = kept_.visiblePoints,
                                                       .live = threads.live(),
                                                       .rayCount = shadowRays_},
                         threads);
    for (std::uint32_t light = 0; light < deviceScene_.lightCount; ++light) {
        roughLight_.sample(level.roughPoints, lightOfLevel, threads, light, pass, shadowRays_);
    }
}

} // namespace hyalite::render
