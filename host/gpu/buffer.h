// Device memory: reached from kernels by its address, or as a table of vec4 texels.
#pragma once

#include "gpu/context.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace hyalite::gpu {

// Host-visible device memory that stays mapped. Its contents are undefined at first.
class Buffer {
public:
    Buffer(); // empty: size 0, address 0
    // Throws Error(Device) when the device has no room, naming `name` and the size.
    Buffer(const Context& context, std::size_t bytes, std::string name);
    ~Buffer();
    Buffer(Buffer&&) noexcept;
    Buffer& operator=(Buffer&&) noexcept;

    [[nodiscard]] std::size_t bytes() const;
    [[nodiscard]] std::uint64_t address() const;
    [[nodiscard]] std::span<std::byte> mapped() const;

    struct Impl;
    [[nodiscard]] const Impl* impl() const { return impl_.get(); }

private:
    std::unique_ptr<Impl> impl_;
};

// A buffer of `count` T. Never of size zero: an empty array holds one element that nobody reads.
template <class T>
class Array {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    Array() = default;
    Array(const Context& context, std::size_t count, std::string name)
        : buffer_(context, (count == 0 ? 1 : count) * sizeof(T), std::move(name)), count_(count) {}
    Array(const Context& context, std::span<const T> values, std::string name)
        : Array(context, values.size(), std::move(name)) {
        write(values);
    }

    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] const Buffer& buffer() const { return buffer_; }
    // The device address in the type that the kernel's arguments want, e.g. shared::RayArray.
    template <class DeviceArray>
    [[nodiscard]] operator DeviceArray() const {
        return DeviceArray{buffer_.address()};
    }
    // Host access; no dispatch that uses the array may be in flight.
    [[nodiscard]] std::span<T> host() const { return {reinterpret_cast<T*>(buffer_.mapped().data()), count_}; }
    void write(std::span<const T> values) const { std::ranges::copy(values, host().begin()); }
    [[nodiscard]] std::vector<T> read() const { return {host().begin(), host().end()}; }

private:
    Buffer buffer_;
    std::size_t count_ = 0;
};

enum class TexelFormat { Float4, Uint4 };

// The one descriptor set: uniform texel buffers at bindings 0 .. bindings - 1 (TABLE_* in shaders/shared).
class TexelTables {
public:
    TexelTables(const Context& context, std::uint32_t bindings);
    ~TexelTables();
    TexelTables(TexelTables&&) noexcept;
    TexelTables& operator=(TexelTables&&) noexcept;

    // Shows `buffer` (16 bytes a texel) at `binding`; the buffer must outlive its use. Not between a Commands::run and
    // the finish that follows. An empty buffer, like a binding never set (Float4), shows one texel of zeros.
    // Throws Error(Device) when it has more texels than the device allows.
    void set(std::uint32_t binding, const Buffer& buffer, TexelFormat format);
    // Device address of the buffer shown at `binding`.
    [[nodiscard]] std::uint64_t shown(std::uint32_t binding) const;

    struct Impl;
    [[nodiscard]] const Impl& impl() const { return *impl_; }

private:
    std::unique_ptr<Impl> impl_;
};

} // namespace hyalite::gpu
