// The file: a header, the photons of the three maps as they stand in memory (little-endian), and a checksum of both.
#include "render/photons/photon_file.h"

#include "base/fnv.h"
#include "base/input_file.h"
#include "base/output_file.h"

#include <bit>
#include <cstring>
#include <limits>

namespace hyalite::render {

static_assert(std::endian::native == std::endian::little);

namespace {

constexpr std::array<char, 8> kMagic{'h', 'y', 'a', 'p', 'h', 'o', 't', '1'};

struct Header {
    std::array<char, 8> magic = kMagic;
    std::uint64_t fingerprint = 0;
    std::array<std::uint64_t, 3> counts{};
};

template <class T>
std::span<const std::byte> bytesOf(const T& value) {
    return std::as_bytes(std::span(&value, 1));
}

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what, const std::string& hint) {
    throw Error(ExitCode::BadInput, SourceLocation{path.string(), 0, 0}, what, hint);
}

} // namespace

void writePhotons(const std::filesystem::path& path, const PhotonLists& lists, std::uint64_t fingerprint) {
    const Header header{.fingerprint = fingerprint,
                        .counts = {lists.global.size(), lists.caustic.size(), lists.shadow.size()}};
    std::vector<std::byte> file;
    const auto append = [&](std::span<const std::byte> bytes) { file.insert(file.end(), bytes.begin(), bytes.end()); };
    append(bytesOf(header));
    for (const auto* photons : {&lists.global, &lists.caustic, &lists.shadow}) {
        append(std::as_bytes(std::span(*photons)));
    }
    append(bytesOf(fnv(file)));
    writeFileAtomically(path, file);
}

PhotonLists readPhotons(const std::filesystem::path& path, std::uint64_t fingerprint) {
    const std::string file = readInputFile(path, std::numeric_limits<std::uint32_t>::max() * sizeof(shared::Photon),
                                           "photon map", SourceLocation{path.string(), 0, 0});
    return parsePhotons(std::as_bytes(std::span(file)), path, fingerprint);
}

PhotonLists parsePhotons(std::span<const std::byte> file, const std::filesystem::path& path,
                         std::uint64_t fingerprint) {
    Header header;
    if (file.size() < sizeof header + sizeof(std::uint64_t)) {
        fail(path, "this is no file of photon maps", "write one with --save-photons");
    }
    std::memcpy(&header, file.data(), sizeof header);
    if (header.magic != kMagic) {
        fail(path, "this is no file of photon maps of this version", "write one with --save-photons");
    }
    const std::size_t payload = file.size() - sizeof header - sizeof(std::uint64_t);
    std::uint64_t left = payload / sizeof(shared::Photon);
    for (const std::uint64_t count : header.counts) {
        if (count > left) {
            fail(path, "the file of photon maps is cut off", "write it anew with --save-photons");
        }
        left -= count;
    }
    std::uint64_t checksum = 0;
    std::memcpy(&checksum, file.data() + file.size() - sizeof checksum, sizeof checksum);
    if (left != 0 || payload % sizeof(shared::Photon) != 0 ||
        checksum != fnv(file.first(file.size() - sizeof checksum))) {
        fail(path, "the file of photon maps is damaged", "write it anew with --save-photons");
    }
    if (header.fingerprint != fingerprint) {
        fail(path, "these photon maps were traced for another scene or with other settings",
             "write them anew with --save-photons; photons, caustic_photons, projection_map, max_depth, seed and the "
             "use of shadow_photons have to be the same");
    }
    PhotonLists lists;
    const std::byte* next = file.data() + sizeof header;
    std::size_t map = 0;
    for (auto* photons : {&lists.global, &lists.caustic, &lists.shadow}) {
        photons->resize(header.counts.at(map++));
        if (!photons->empty()) { // nothing may not be copied to nowhere
            std::memcpy(photons->data(), next, photons->size() * sizeof(shared::Photon));
        }
        next += photons->size() * sizeof(shared::Photon);
    }
    return lists;
}

} // namespace hyalite::render
