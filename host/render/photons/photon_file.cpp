// The file: a header, the identity as lines NAME=VALUE, the photons of the three maps as in memory (little-endian), and
// a checksum of everything before it.
#include "render/photons/photon_file.h"

#include "base/fnv.h"
#include "base/input_file.h"
#include "base/output_file.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>

namespace hyalite::render {

static_assert(std::endian::native == std::endian::little);

namespace {

constexpr std::array<char, 8> kMagic{'h', 'y', 'a', 'p', 'h', 'o', 't', '2'};
constexpr std::array<char, 8> kMagicBefore{'h', 'y', 'a', 'p', 'h', 'o', 't', '1'};

struct Header {
    std::array<char, 8> magic = kMagic;
    std::uint64_t identityBytes = 0;
    std::array<std::uint64_t, 3> counts{};
};

template <class T>
std::span<const std::byte> bytesOf(const T& value) {
    return std::as_bytes(std::span(&value, 1));
}

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what, const std::string& hint) {
    throw Error(ExitCode::BadInput, SourceLocation{path.string(), 0, 0}, what, hint);
}

std::string textOf(const RenderIdentity& identity) {
    std::string text = "scene=" + identity.scene + '\n';
    for (const auto& [name, value] : identity.settings) {
        text += name + '=' + value + '\n';
    }
    return text;
}

RenderIdentity parseIdentity(std::span<const std::byte> bytes) {
    RenderIdentity identity;
    std::istringstream lines(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    for (std::string line; std::getline(lines, line);) {
        const std::size_t equals = std::min(line.find('='), line.size() - 1);
        const std::string name = line.substr(0, equals);
        if (name == "scene") {
            identity.scene = line.substr(equals + 1);
        } else {
            identity.settings.emplace_back(name, line.substr(equals + 1));
        }
    }
    return identity;
}

} // namespace

void writePhotons(const std::filesystem::path& path, const PhotonLists& lists, const RenderIdentity& identity) {
    const std::string text = textOf(identity);
    const Header header{.identityBytes = text.size(),
                        .counts = {lists.global.size(), lists.caustic.size(), lists.shadow.size()}};
    std::vector<std::byte> file;
    const auto append = [&](std::span<const std::byte> bytes) { file.insert(file.end(), bytes.begin(), bytes.end()); };
    append(bytesOf(header));
    append(std::as_bytes(std::span(text)));
    for (const auto* photons : {&lists.global, &lists.caustic, &lists.shadow}) {
        append(std::as_bytes(std::span(*photons)));
    }
    append(bytesOf(fnv(file)));
    writeFileAtomically(path, file);
}

PhotonLists readPhotons(const std::filesystem::path& path, const RenderIdentity& identity) {
    const std::string file = readInputFile(path, std::numeric_limits<std::uint32_t>::max() * sizeof(shared::Photon),
                                           "photon map", SourceLocation{path.string(), 0, 0});
    return parsePhotons(std::as_bytes(std::span(file)), path, identity);
}

PhotonLists parsePhotons(std::span<const std::byte> file, const std::filesystem::path& path,
                         const RenderIdentity& identity) {
    const std::string again = "write it again with --save-photons";
    Header header;
    if (file.size() >= kMagicBefore.size() && std::memcmp(file.data(), kMagicBefore.data(), kMagicBefore.size()) == 0) {
        fail(path, "the photon maps are from an earlier version of the program", again);
    }
    if (file.size() < sizeof header + sizeof(std::uint64_t)) {
        fail(path, "not a file of photon maps", "write one with --save-photons");
    }
    std::memcpy(&header, file.data(), sizeof header);
    if (header.magic != kMagic) {
        fail(path, "not a file of photon maps of this version", "write one with --save-photons");
    }
    const std::size_t content = file.size() - sizeof header - sizeof(std::uint64_t);
    if (header.identityBytes > content) {
        fail(path, "the file of photon maps is corrupt: it is truncated", again);
    }
    const std::size_t payload = content - header.identityBytes;
    std::uint64_t left = payload / sizeof(shared::Photon);
    for (const std::uint64_t count : header.counts) {
        if (count > left) {
            fail(path, "the file of photon maps is corrupt: it is truncated", again);
        }
        left -= count;
    }
    std::uint64_t checksum = 0;
    std::memcpy(&checksum, file.data() + file.size() - sizeof checksum, sizeof checksum);
    if (left != 0 || payload % sizeof(shared::Photon) != 0 ||
        checksum != fnv(file.first(file.size() - sizeof checksum))) {
        fail(path, "the file of photon maps is corrupt: checksum mismatch", again);
    }
    const RenderIdentity there = parseIdentity(file.subspan(sizeof header, header.identityBytes));
    if (const std::string differs = difference(there, identity); !differs.empty()) {
        fail(path, "the photon maps are from a different render: " + differs, again);
    }
    PhotonLists lists;
    const std::byte* next = file.data() + sizeof header + header.identityBytes;
    std::size_t map = 0;
    for (auto* photons : {&lists.global, &lists.caustic, &lists.shadow}) {
        photons->resize(header.counts.at(map++));
        if (!photons->empty()) { // memcpy forbids a null destination even for zero bytes
            std::memcpy(photons->data(), next, photons->size() * sizeof(shared::Photon));
        }
        next += photons->size() * sizeof(shared::Photon);
    }
    return lists;
}

} // namespace hyalite::render
