#include "live/worker/debug_prints.h"

#include "shaders/shared/debug_records.h"
#include "shaders/shared/limits.h"
#include "shaders/shared/scene_records.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>
#include <span>
#include <utility>

namespace hyalite::live {

namespace {

constexpr std::uint32_t kRecords = 4096; // room for the prints of one dispatch
constexpr std::size_t kMostLines = 512;  // kept until take()

using Record = std::array<std::uint32_t, shared::kDebugWords>;

std::string component(std::uint32_t kind, std::uint32_t bits) {
    std::array<char, 32> text{};
    if ((kind & 0xf0U) == shared::kDebugFloat) {
        std::snprintf(text.data(), text.size(), " %.7g", static_cast<double>(std::bit_cast<float>(bits)));
    } else if ((kind & 0xf0U) == shared::kDebugInt) {
        std::snprintf(text.data(), text.size(), " %d", static_cast<std::int32_t>(bits));
    } else {
        std::snprintf(text.data(), text.size(), " %u", bits);
    }
    return text.data();
}

std::string lineOf(const std::string& kernel, const Record& record) {
    std::string text = kernel + ':' + std::to_string(record[1]) + " thread " + std::to_string(record[0]) + ':';
    const std::uint32_t components = std::min(record[2] & 0xfU, 4U);
    for (std::uint32_t i = 0; i < components; ++i) {
        text += component(record[2], record.at(3 + i));
    }
    return text;
}

} // namespace

DebugPrints::DebugPrints(const gpu::Context& context, gpu::TexelTables& tables)
    : words_(context, shared::kDebugHeader + kRecords * shared::kDebugWords, "debug prints", gpu::Memory::Host),
      address_(context, 1, "address of debug prints", gpu::Memory::Host), tables_(tables) {
    std::ranges::fill(words_.host(), 0U);
    words_.host()[shared::kDebugRoom] = kRecords;
    address_.host()[0] = glm::vec4(0);
    tables_.set(TABLE_DEBUG, address_.buffer(), gpu::TexelFormat::Float4);
}

void DebugPrints::listen(bool on, std::uint32_t pixel) {
    isOn_ = on;
    words_.host()[shared::kDebugCount] = 0;
    words_.host()[shared::kDebugPixel] = pixel;
    const std::uint64_t address = on ? words_.buffer().address() : 0;
    for (int part = 0; part < 4; ++part) {
        address_.host()[0][part] = static_cast<float>(address >> (16 * part) & 0xffffU);
    }
}

void DebugPrints::collect(const std::string& kernel) {
    const std::span<std::uint32_t> words = words_.host();
    const std::uint32_t count = words[shared::kDebugCount];
    if (!isOn_ || count == 0) {
        return;
    }
    words[shared::kDebugCount] = 0;
    std::vector<Record> records(std::min(count, kRecords));
    for (std::size_t i = 0; i < records.size(); ++i) {
        std::ranges::copy(words.subspan(shared::kDebugHeader + i * shared::kDebugWords, shared::kDebugWords),
                          records[i].begin());
    }
    std::ranges::sort(records); // threads printed in any order
    const std::size_t room = kMostLines - std::min(kMostLines, prints_.lines.size());
    const std::size_t kept = std::min(room, records.size());
    for (std::size_t i = 0; i < kept; ++i) {
        prints_.lines.push_back(lineOf(kernel, records[i]));
    }
    prints_.lost += count - kept;
}

DebugPrints::Prints DebugPrints::take() {
    return std::exchange(prints_, Prints());
}

} // namespace hyalite::live
