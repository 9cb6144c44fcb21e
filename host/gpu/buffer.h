// Device memory: reached from kernels by its address, or as a table of vec4 texels.
#pragma once

#include "gpu/context.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace hyalite::gpu {

// Where a buffer lies.
enum class Memory {
    Device, // where kernels reach it fastest; the host reads and writes it by copies if it does not see that memory
    Host,   // always mapped: for the little that the host and kernels hand each other
};

// Device memory. Its contents are undefined at first.
class Buffer {
public:
    Buffer(); // empty: size 0, address 0
    // Throws Error(Device) when the device has no room, naming `name` and the size.
    Buffer(const Context& context, std::size_t bytes, std::string name, Memory memory = Memory::Device);
    ~Buffer();
    Buffer(Buffer&&) noexcept;
    Buffer& operator=(Buffer&&) noexcept;

    [[nodiscard]] std::size_t bytes() const;
    [[nodiscard]] std::uint64_t address() const;

    // Copies from or to the buffer, from byte `offset` on; no dispatch that uses it may be in flight.
    // Throws Error(Device) when the device fails, Error(BadInput) beyond the buffer's end.
    void read(std::span<std::byte> to, std::size_t offset = 0) const;
    void write(std::span<const std::byte> from, std::size_t offset = 0) const;

    // The buffer itself; empty where the host does not see it, never with Memory::Host.
    [[nodiscard]] std::span<std::byte> mapped() const;

    struct Impl;
    [[nodiscard]] const Impl* impl() const { return impl_.get(); }

private:
    std::unique_ptr<Impl> impl_;
};

[[noreturn]] void refuseHostAccess(const Buffer& buffer);

// A buffer of `count` T. Never of size zero: an empty array holds one element that nobody reads.
template <class T>
class Array {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    Array() = default;
    Array(const Context& context, std::size_t count, std::string name, Memory memory = Memory::Device)
        : buffer_(context, (count == 0 ? 1 : count) * sizeof(T), std::move(name), memory), count_(count) {}
    Array(const Context& context, std::span<const T> values, std::string name, Memory memory = Memory::Device)
        : Array(context, values.size(), std::move(name), memory) {
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
    void write(std::span<const T> values, std::size_t first = 0) const {
        if (!values.empty()) {
            buffer_.write(std::as_bytes(values), first * sizeof(T));
        }
    }
    void fill(const T& value) const { write(std::vector<T>(count_, value)); }
    [[nodiscard]] std::vector<T> read() const { return read(0, count_); }
    [[nodiscard]] std::vector<T> read(std::size_t first, std::size_t count) const {
        std::vector<T> values(count);
        if (count > 0) {
            buffer_.read(std::as_writable_bytes(std::span(values)), first * sizeof(T));
        }
        return values;
    }
    [[nodiscard]] T read(std::size_t index) const { return read(index, 1).front(); }
    // The elements in place: for arrays with Memory::Host; of others it throws Error(BadInput) where the host does not
    // see them.
    [[nodiscard]] std::span<T> host() const {
        const std::span<std::byte> bytes = buffer_.mapped();
        if (count_ > 0 && bytes.empty()) {
            refuseHostAccess(buffer_);
        }
        return {reinterpret_cast<T*>(bytes.data()), bytes.empty() ? 0 : count_};
    }

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
