#include "gpu/context_impl.h"

#include "base/numbers.h"

namespace hyalite::gpu {

void setWatchdog(const Context& context, Watchdog watchdog) {
    context.impl().watchdog = std::move(watchdog);
}

void Context::Impl::wait(const vk::raii::Fence& fence, const std::string& stages) const {
    const vk::Result result = device.waitForFences(*fence, VK_TRUE, nanoseconds(watchdog.limit));
    if (result == vk::Result::eTimeout) {
        const Error stuck(ExitCode::Device,
                          info.name + " has not finished within " + numberText(watchdog.limit) + " s (stages " +
                              stages + ')',
                          "it hangs, or the work is too much for it: --device-timeout allows more; a checkpoint keeps "
                          "what was done before");
        if (watchdog.onStuck) {
            watchdog.onStuck(stuck.what());
        }
        throw Error(stuck);
    }
    requireSuccess(result, "waiting for the device");
}

} // namespace hyalite::gpu
