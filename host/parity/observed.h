// One observed dispatch: its arguments, and the memory that they name before and after it.
#pragma once

#include "gpu/buffer.h"
#include "gpu/dispatch_observer.h"

#include "shaders/shared/queue.h"

#include <cstring>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace hyalite::parity {

class Observed {
public:
    static constexpr std::size_t kWhole = SIZE_MAX / 1024; // elements: as many as the buffer has

    // Copies all buffers that the arguments name. To be made before the dispatch.
    Observed(const gpu::Context& context, const gpu::TexelTables& tables, const gpu::Dispatch& dispatch);

    [[nodiscard]] const std::string& kernel() const { return kernel_; }

    template <class Arguments>
    [[nodiscard]] Arguments arguments() const {
        Arguments arguments;
        std::memcpy(&arguments, arguments_.data(), sizeof(arguments));
        return arguments;
    }

    // `count` elements of a device array, as they were before the dispatch.
    template <class T, class DeviceArray>
    [[nodiscard]] std::span<const T> before(const DeviceArray& array, std::size_t count) const {
        return typed<T>(copyAt(array.address), count);
    }
    // … and as they are now.
    template <class T, class DeviceArray>
    [[nodiscard]] std::span<const T> after(const DeviceArray& array, std::size_t count) const {
        return typed<T>(context_.memoryAt(array.address), count);
    }
    // How many elements the dispatch was for: a number that the host gave, or the first of an array on the device,
    // where an earlier kernel counted them (indirect dispatch).
    [[nodiscard]] static std::uint32_t count(std::uint32_t given) { return given; }
    template <class DeviceArray>
    [[nodiscard]] std::uint32_t count(const DeviceArray& array) const {
        const auto counted = before<std::uint32_t>(array, 1);
        return counted.empty() ? 0 : counted.front();
    }

    // A table of texels, from element `first` on.
    template <class T>
    [[nodiscard]] std::span<const T> table(std::uint32_t binding, std::size_t first, std::size_t count) const {
        const auto bytes = context_.memoryAt(tables_.shown(binding));
        return first * sizeof(T) <= bytes.size() ? typed<T>(bytes.subspan(first * sizeof(T)), count)
                                                 : std::span<const T>();
    }

private:
    [[nodiscard]] std::span<const std::byte> copyAt(std::uint64_t address) const;
    // No more elements than there are bytes.
    template <class T>
    [[nodiscard]] static std::span<const T> typed(std::span<const std::byte> bytes, std::size_t count) {
        return {reinterpret_cast<const T*>(bytes.data()), std::min(count, bytes.size() / sizeof(T))};
    }

    const gpu::Context& context_;
    const gpu::TexelTables& tables_;
    std::string kernel_;
    std::vector<std::byte> arguments_;
    std::map<std::uint64_t, std::vector<std::byte>> copies_; // by address
};

// The photons that scatter_photon or cast_shadow_photons has left, one for each thread.
template <class Arguments>
[[nodiscard]] std::span<const shared::Photon> photonsStored(const Observed& dispatch, const Arguments& args) {
    const auto live = dispatch.before<shared::QueueSize>(args.live, 1);
    const std::uint32_t first = args.firstPhoton + (live.empty() ? 0 : live[0].before); // they may wrap
    return dispatch.after<shared::Photon>(args.photons, std::size_t{first} + args.count).subspan(first);
}

} // namespace hyalite::parity
