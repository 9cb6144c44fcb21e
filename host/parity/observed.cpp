#include "parity/observed.h"

namespace hyalite::parity {

Observed::Observed(const gpu::Context& context, const gpu::TexelTables& tables, const gpu::Dispatch& dispatch)
    : context_(context), tables_(tables), kernel_(dispatch.kernel.name()),
      arguments_(dispatch.arguments.begin(), dispatch.arguments.end()) {
    // Structs have scalar layout: an address may be at any multiple of 4
    for (std::size_t at = 0; at + sizeof(std::uint64_t) <= arguments_.size(); at += 4) {
        std::uint64_t address = 0;
        std::memcpy(&address, arguments_.data() + at, sizeof(address));
        const auto memory = context.memoryAt(address);
        copies_.try_emplace(address, memory.begin(), memory.end());
    }
}

std::span<const std::byte> Observed::copyAt(std::uint64_t address) const {
    const auto found = copies_.find(address);
    return found == copies_.end() ? std::span<const std::byte>() : std::span<const std::byte>(found->second);
}

} // namespace hyalite::parity
