// Records dispatches with a barrier after each, submits them in portions, and reads the timestamps back.
#include "gpu/commands.h"

#include "base/numbers.h"
#include "gpu/buffer_impl.h"
#include "gpu/checked_kernels.h"
#include "gpu/kernel_impl.h"
#include "shaders/shared/limits.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <set>
#include <utility>

namespace hyalite::gpu {
namespace {

// Threads of one dispatch: a full row of groups. A GPU that draws the desktop as well stops what runs for seconds.
constexpr std::uint32_t kGroupsPerPiece = shared::kGroupsPerRow;

// Threads of one submission, which is what a GPU's watchdog watches.
constexpr std::uint64_t kThreadsPerSubmission = std::uint64_t(1) << 23U;

constexpr std::uint32_t kQueriesPerPool = 256;
constexpr std::uint32_t kSpansPerPool = kQueriesPerPool / 2;

// One timed span: two successive timestamps.
struct Span {
    std::string name;
    std::uint64_t dispatches = 0;
    std::uint64_t threads = 0;
    const ThreadCount* onDevice = nullptr; // while it is recorded: where the number of threads stands
    bool isCounted = false;                // it is among Impl::counts
};

// Everything before it is done, and seen by everything after it.
void recordBarrier(const vk::raii::CommandBuffer& buffer, vk::PipelineStageFlags2 after, vk::AccessFlags2 access) {
    using Stage = vk::PipelineStageFlagBits2;
    using Access = vk::AccessFlagBits2;
    const vk::MemoryBarrier2 barrier{.srcStageMask = Stage::eComputeShader | Stage::eDrawIndirect | Stage::eAllTransfer,
                                     .srcAccessMask = Access::eShaderWrite | Access::eTransferWrite,
                                     .dstStageMask = after,
                                     .dstAccessMask = access};
    buffer.pipelineBarrier2(vk::DependencyInfo{.memoryBarrierCount = 1, .pMemoryBarriers = &barrier});
}

void recordBarrier(const vk::raii::CommandBuffer& buffer) {
    using Stage = vk::PipelineStageFlagBits2;
    using Access = vk::AccessFlagBits2;
    recordBarrier(buffer, Stage::eComputeShader | Stage::eDrawIndirect | Stage::eAllTransfer,
                  Access::eShaderRead | Access::eShaderWrite | Access::eIndirectCommandRead | Access::eTransferRead |
                      Access::eTransferWrite);
}

std::uint32_t groupsOf(std::uint32_t threads) {
    return (threads - 1) / shared::kGroupSize + 1;
}

// When nothing runs.
std::uint32_t countNow(const ThreadCount& threads) {
    if (!threads.isOnDevice()) {
        return threads.most();
    }
    shared::QueueSize size{};
    threads.sizes().read(std::as_writable_bytes(std::span(&size, 1)), threads.offset());
    return std::min(size.count, threads.most());
}

const StructMember* findMember(const KernelInterface& interface, const std::string& name) {
    for (const auto& [type, members] : interface.structs) {
        if (type.ends_with("Arguments")) {
            const auto found = std::ranges::find(members, name, &StructMember::name);
            return found == members.end() ? nullptr : &*found;
        }
    }
    return nullptr;
}

// The arguments with the `count` that their `live` gives when nothing runs: see shared/kernel_arguments.h.
std::vector<std::byte> withCountNow(const Context& context, const KernelInterface& interface,
                                    std::span<const std::byte> arguments) {
    std::vector<std::byte> resolved(arguments.begin(), arguments.end());
    const StructMember* live = findMember(interface, "live");
    const StructMember* count = findMember(interface, "count");
    if (live == nullptr || count == nullptr) {
        return resolved;
    }
    std::uint64_t address = 0;
    std::memcpy(&address, arguments.data() + live->offset, sizeof address);
    const std::span<const std::byte> memory = context.memoryAt(address);
    if (memory.size() < sizeof(shared::QueueSize)) {
        return resolved;
    }
    std::uint32_t most = 0;
    std::uint32_t now = 0;
    std::memcpy(&most, arguments.data() + count->offset, sizeof most);
    std::memcpy(&now, memory.data() + offsetof(shared::QueueSize, count), sizeof now);
    now = std::min(now, most);
    std::memcpy(resolved.data() + count->offset, &now, sizeof now);
    return resolved;
}

} // namespace

struct Commands::Impl {
    const Context& owner;
    const Context::Impl& context;
    const TexelTables::Impl& tables;
    bool timed;
    vk::raii::CommandPool pool = nullptr;
    std::vector<vk::raii::CommandBuffer> buffers; // the first `used` hold work that is not finished
    std::size_t used = 0;
    bool recording = false;            // into the last used one
    std::uint64_t threadsRecorded = 0; // in it
    vk::raii::Fence fence = nullptr;
    std::vector<vk::raii::QueryPool> queries;
    std::vector<Array<std::uint32_t>> counts; // by pool: threads of each span whose number stands on the device
    std::vector<Span> spans;                  // of the work that is not finished; span i has timestamps 2 i and 2 i + 1
    std::set<std::string> stages;             // of the work that is not finished
    std::map<std::string, StageTime> times;
    std::shared_ptr<std::vector<DispatchObserver*>> observers = std::make_shared<std::vector<DispatchObserver*>>();

    Impl(const Context& itsOwner, const TexelTables::Impl& allTables, bool isTimed)
        : owner(itsOwner), context(itsOwner.impl()), tables(allTables), timed(isTimed),
          pool(context.device, vk::CommandPoolCreateInfo{.queueFamilyIndex = context.queueFamily}),
          fence(context.device, vk::FenceCreateInfo{}) {}

    // The command buffer being recorded; begins one where there is none.
    const vk::raii::CommandBuffer& recorder();
    // Ends the command buffer and hands it to the queue; a fence is signalled when all work so far is done.
    void submit(vk::Fence signal);
    void writeTimestamp(std::size_t index);
    // Records `body` between two timestamps and a barrier after it.
    template <class Body>
    void record(const Span& span, const Body& body);
    // Keeps the number of threads that the next span has on the device.
    void copyCount(const ThreadCount& threads);
    void addTimes();
    [[nodiscard]] std::string stageNames() const;
};

const vk::raii::CommandBuffer& Commands::Impl::recorder() {
    if (!recording) {
        if (used == buffers.size()) {
            vk::raii::CommandBuffers made(context.device,
                                          vk::CommandBufferAllocateInfo{.commandPool = *pool, .commandBufferCount = 1});
            buffers.push_back(std::move(made.front()));
        }
        buffers[used].begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
        ++used;
        recording = true;
        threadsRecorded = 0;
    }
    return buffers[used - 1];
}

void Commands::Impl::submit(vk::Fence signal) {
    const vk::raii::CommandBuffer& buffer = recorder();
    buffer.end();
    recording = false;
    const vk::CommandBufferSubmitInfo info{.commandBuffer = *buffer};
    context.queue.submit2(vk::SubmitInfo2{.commandBufferInfoCount = 1, .pCommandBufferInfos = &info}, signal);
}

void Commands::Impl::writeTimestamp(std::size_t index) {
    const std::size_t poolIndex = index / kQueriesPerPool;
    const auto query = std::uint32_t(index % kQueriesPerPool);
    if (poolIndex == queries.size()) {
        queries.emplace_back(context.device, vk::QueryPoolCreateInfo{.queryType = vk::QueryType::eTimestamp,
                                                                     .queryCount = kQueriesPerPool});
    }
    if (query == 0) {
        recorder().resetQueryPool(*queries[poolIndex], 0, kQueriesPerPool);
    }
    recorder().writeTimestamp2(vk::PipelineStageFlagBits2::eAllCommands, *queries[poolIndex], query);
}

template <class Body>
void Commands::Impl::record(const Span& span, const Body& body) {
    stages.insert(span.name);
    if (timed) {
        writeTimestamp(2 * spans.size());
        if (span.onDevice != nullptr) {
            copyCount(*span.onDevice);
        }
    }
    body();
    recordBarrier(recorder());
    if (timed) {
        writeTimestamp(2 * spans.size() + 1);
        spans.push_back(span);
        spans.back().isCounted = span.onDevice != nullptr;
        spans.back().onDevice = nullptr;
    }
}

void Commands::Impl::copyCount(const ThreadCount& threads) {
    const std::size_t part = spans.size() / kSpansPerPool;
    while (counts.size() <= part) {
        counts.emplace_back(owner, kSpansPerPool, "threads of stages", Memory::Host);
    }
    recorder().copyBuffer(*threads.sizes().impl()->buffer, *counts[part].buffer().impl()->buffer,
                          vk::BufferCopy{.srcOffset = threads.offset() + offsetof(shared::QueueSize, count),
                                         .dstOffset = spans.size() % kSpansPerPool * sizeof(std::uint32_t),
                                         .size = sizeof(std::uint32_t)});
}

void Commands::Impl::addTimes() {
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const std::size_t first = 2 * i; // both of a span are in one pool: its size is even
        const auto [result, ticks] = queries[first / kQueriesPerPool].getResults<std::uint64_t>(
            std::uint32_t(first % kQueriesPerPool), 2, 2 * sizeof(std::uint64_t), sizeof(std::uint64_t),
            vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait);
        requireSuccess(result, "reading timestamps");
        StageTime& time = times[spans[i].name];
        time.seconds += double((ticks[1] - ticks[0]) & context.timestampMask) * context.secondsPerTick;
        const std::uint64_t threads =
            spans[i].isCounted ? counts[i / kSpansPerPool].host()[i % kSpansPerPool] : spans[i].threads;
        time.dispatches += spans[i].isCounted && threads == 0 ? 0 : spans[i].dispatches;
        time.threads += threads;
    }
    spans.clear();
}

std::string Commands::Impl::stageNames() const {
    std::string names;
    for (const std::string& stage : stages) {
        names += (names.empty() ? "" : ", ") + stage;
    }
    return names;
}

Commands::Commands(const Context& context, const TexelTables& tables, bool timed)
    : impl_(checked("making a command list", [&] { return std::make_unique<Impl>(context, tables.impl(), timed); })) {}

Commands::~Commands() {
    // Portions may be running still, in memory that goes away now.
    if (impl_->used > 0) {
        try {
            impl_->context.device.waitIdle();
        } catch (const vk::SystemError&) {
            return; // the device is lost: nothing runs
        }
    }
}

void Commands::run(const Kernel& kernel, std::span<const std::byte> arguments, const ThreadCount& threads) {
    if (threads.most() == 0) {
        return;
    }
    const Kernel::Impl& implementation = kernel.impl();
    if (arguments.size() != implementation.interface.pushConstantBytes) {
        throw Error(ExitCode::BadInput, "kernel '" + kernel.name() + "' takes " +
                                            std::to_string(implementation.interface.pushConstantBytes) +
                                            " bytes of arguments, not " + std::to_string(arguments.size()));
    }
    for (const auto& [binding, format] : implementation.interface.tables) {
        if (impl_->tables.formats.at(binding) != format) {
            throw Error(ExitCode::BadInput, "kernel '" + kernel.name() + "' reads table " + std::to_string(binding) +
                                                " in another format than it was set in");
        }
    }
    if (!runsOneByOne() && !threads.isOnDevice()) {
        record(kernel, arguments, {.first = 0, .end = groupsOf(threads.most()), .threads = threads.most()});
    } else if (!runsOneByOne() && threads.most() <= kThreadsPerSubmission) {
        recordIndirect(kernel, arguments, threads);
    } else {
        finish();
        if (const std::uint32_t count = countNow(threads); count > 0) {
            runAlone(kernel, arguments, count);
        }
    }
}

// When all work before is finished.
void Commands::runAlone(const Kernel& kernel, std::span<const std::byte> arguments, std::uint32_t threads) {
    const std::uint32_t groups = groupsOf(threads);
    if constexpr (kCheckedKernels) {
        impl_->tables.describeBuffers();
    }
    const std::vector<DispatchObserver*>& observers = *impl_->observers;
    if (observers.empty()) {
        record(kernel, arguments, {.first = 0, .end = groups, .threads = threads});
        if constexpr (kCheckedKernels) {
            finish();
            if (const std::string what = impl_->tables.indexOutside(kernel.impl().sources); !what.empty()) {
                throw Error(ExitCode::Device, "kernel '" + kernel.name() + "': " + what);
            }
        }
        return;
    }
    const std::vector<std::byte> seen = withCountNow(impl_->owner, kernel.interface(), arguments);
    const Dispatch dispatch{kernel, seen, threads};
    for (auto observer = observers.rbegin(); observer != observers.rend(); ++observer) {
        (*observer)->before(dispatch);
    }
    std::uint32_t threadsOfPiece = std::numeric_limits<std::uint32_t>::max();
    for (const DispatchObserver* observer : observers) {
        threadsOfPiece = std::min(threadsOfPiece, observer->threadsOfPiece());
    }
    // lib/thread.glsl counts on it that a piece which does not begin a row begins after as many groups as it has
    const std::uint32_t wanted = std::max(1U, threadsOfPiece / shared::kGroupSize);
    const std::uint32_t piece = std::min(std::bit_floor(wanted), kGroupsPerPiece);
    for (std::uint32_t first = 0; first < groups;) {
        if (first > 0) {
            std::ranges::for_each(observers, &DispatchObserver::between);
        }
        const std::uint32_t end = groups - first > piece ? first + piece : groups;
        record(kernel, arguments, {.first = first, .end = end, .threads = threads});
        finish();
        first = end;
    }
    for (DispatchObserver* observer : observers) {
        observer->after(dispatch);
    }
}

void Commands::record(const Kernel& kernel, std::span<const std::byte> arguments, const Groups& groups) {
    const Kernel::Impl& implementation = kernel.impl();
    checked("recording kernel '" + kernel.name() + '\'', [&] {
        const std::uint64_t end = std::uint64_t(groups.end) * shared::kGroupSize;
        const std::uint64_t threads =
            std::min<std::uint64_t>(end, groups.threads) - std::uint64_t(groups.first) * shared::kGroupSize;
        impl_->record({.name = kernel.name(), .dispatches = groups.first == 0 ? 1U : 0U, .threads = threads}, [&] {
            const auto stage = vk::ShaderStageFlagBits::eCompute;
            for (std::uint32_t at = groups.first; at < groups.end;) {
                const vk::raii::CommandBuffer& buffer = impl_->recorder();
                buffer.bindPipeline(vk::PipelineBindPoint::eCompute, *implementation.pipeline);
                buffer.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *implementation.layout, 0,
                                          *impl_->tables.set, nullptr);
                buffer.pushConstants<std::byte>(*implementation.layout, stage, 0, arguments);
                const std::uint32_t inRow = at % kGroupsPerPiece;
                const std::uint32_t width = std::min(groups.end - at, kGroupsPerPiece - inRow);
                buffer.dispatchBase(inRow, at / kGroupsPerPiece, 0, width, 1, 1);
                at += width;
                impl_->threadsRecorded += std::uint64_t(width) * shared::kGroupSize;
                if (impl_->threadsRecorded >= kThreadsPerSubmission) {
                    impl_->submit({});
                }
            }
        });
    });
}

void Commands::recordIndirect(const Kernel& kernel, std::span<const std::byte> arguments, const ThreadCount& threads) {
    const Kernel::Impl& implementation = kernel.impl();
    checked("recording kernel '" + kernel.name() + '\'', [&] {
        impl_->record({.name = kernel.name(), .dispatches = 1, .threads = 0, .onDevice = &threads}, [&] {
            const vk::raii::CommandBuffer& buffer = impl_->recorder();
            buffer.bindPipeline(vk::PipelineBindPoint::eCompute, *implementation.pipeline);
            buffer.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *implementation.layout, 0, *impl_->tables.set,
                                      nullptr);
            buffer.pushConstants<std::byte>(*implementation.layout, vk::ShaderStageFlagBits::eCompute, 0, arguments);
            buffer.dispatchIndirect(*threads.sizes().impl()->buffer,
                                    threads.offset() + offsetof(shared::QueueSize, groupsX));
            impl_->threadsRecorded += threads.most();
            if (impl_->threadsRecorded >= kThreadsPerSubmission) {
                impl_->submit({});
            }
        });
    });
}

void Commands::prepare(const Kernel& kernel) {
    checked("preparing kernel '" + kernel.name() + '\'', [&] {
        const Kernel::Impl& implementation = kernel.impl();
        const std::vector<std::byte> arguments(implementation.interface.pushConstantBytes);
        const vk::raii::CommandBuffer& buffer = impl_->recorder();
        buffer.bindPipeline(vk::PipelineBindPoint::eCompute, *implementation.pipeline);
        buffer.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *implementation.layout, 0, *impl_->tables.set,
                                  nullptr);
        buffer.pushConstants<std::byte>(*implementation.layout, vk::ShaderStageFlagBits::eCompute, 0, arguments);
        buffer.dispatch(0, 1, 1);
    });
}

void Commands::clear(const Buffer& buffer) {
    if (buffer.impl() != nullptr) {
        clear(buffer, (buffer.bytes() + 3) / 4 * 4); // Vulkan's buffer is a multiple of 4 long
    }
}

void Commands::clear(const Buffer& buffer, std::size_t bytes) {
    if (bytes == 0) {
        return;
    }
    if (bytes % 4 != 0 || bytes > (buffer.bytes() + 3) / 4 * 4) {
        throw Error(ExitCode::BadInput, "cannot clear " + std::to_string(bytes) + " bytes of a buffer of " +
                                            std::to_string(buffer.bytes()));
    }
    checked("recording a clear", [&] {
        impl_->record({.name = "clear", .dispatches = 1, .threads = 0},
                      [&] { impl_->recorder().fillBuffer(*buffer.impl()->buffer, 0, bytes, 0); });
    });
}

void Commands::copy(const Buffer& from, const Buffer& to) {
    if (from.bytes() == 0) {
        return;
    }
    if (from.bytes() > to.bytes()) {
        throw Error(ExitCode::BadInput, "cannot copy " + std::to_string(from.bytes()) + " bytes to a buffer of " +
                                            std::to_string(to.bytes()));
    }
    checked("recording a copy", [&] {
        impl_->record({.name = "copy", .dispatches = 1, .threads = 0}, [&] {
            impl_->recorder().copyBuffer(*from.impl()->buffer, *to.impl()->buffer,
                                         vk::BufferCopy{.srcOffset = 0, .dstOffset = 0, .size = from.bytes()});
        });
    });
}

void Commands::set(const Buffer& buffer, std::span<const std::byte> bytes) {
    constexpr std::size_t kMost = 65536; // that a command may carry
    if (bytes.empty()) {
        return;
    }
    if (bytes.size() % 4 != 0 || bytes.size() > kMost || bytes.size() > (buffer.bytes() + 3) / 4 * 4) {
        throw Error(ExitCode::BadInput, "cannot set " + std::to_string(bytes.size()) + " bytes of a buffer of " +
                                            std::to_string(buffer.bytes()));
    }
    checked("recording values", [&] {
        impl_->record({.name = "set", .dispatches = 1, .threads = 0},
                      [&] { impl_->recorder().updateBuffer<std::byte>(*buffer.impl()->buffer, 0, bytes); });
    });
}

void Commands::finish() {
    if (impl_->used == 0) {
        return;
    }
    checked("running on " + impl_->context.info.name, [&] {
        using Stage = vk::PipelineStageFlagBits2;
        recordBarrier(impl_->recorder(), Stage::eHost, vk::AccessFlagBits2::eHostRead);
        impl_->submit(*impl_->fence);
        impl_->context.wait(impl_->fence, impl_->stageNames());
        impl_->context.device.resetFences(*impl_->fence);
        impl_->stages.clear();
        impl_->addTimes();
        impl_->pool.reset();
        impl_->used = 0;
    });
}

Observation Commands::observe(DispatchObserver& observer) {
    return {impl_->observers, &observer};
}

bool Commands::runsOneByOne() const {
    return kCheckedKernels || !impl_->observers->empty();
}

bool Commands::areBuffersRead() const {
    return std::ranges::any_of(*impl_->observers, &DispatchObserver::readsBuffers);
}

const std::map<std::string, StageTime>& Commands::times() const {
    return impl_->times;
}

} // namespace hyalite::gpu
