// The file: a header of fixed size, the identity, the names of the layers and the counts as lines of text, the ranges
// of passes, the faults, the sums word by word (little-endian; a plane of high words that are all zero is omitted), a
// bit for each pixel where light was sought, and a checksum.
#include "render/film/checkpoint.h"

#include "base/error.h"
#include "base/fnv.h"
#include "base/input_file.h"
#include "base/output_file.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <sstream>
#include <type_traits>

namespace hyalite::render {

static_assert(std::endian::native == std::endian::little);

namespace {

constexpr std::array<char, 8> kMagic{'h', 'y', 'a', 'c', 'h', 'k', 'p', '3'};

// More than the largest picture with five layers takes.
constexpr std::size_t kLargestFile = std::size_t{1} << 38U;

constexpr std::uint32_t kMostLayers = 64;

struct Header {
    std::array<char, 8> magic = kMagic;
    glm::uvec2 resolution{0};
    std::uint32_t layers = 0;
    std::uint32_t ranges = 0;
    std::uint32_t textBytes = 0;
    std::uint32_t unused = 0;
    double seconds = 0;
};
static_assert(std::is_trivially_copyable_v<Header>);
static_assert(sizeof(FilmFault) == 16 && sizeof(PassRange) == 8);

constexpr std::uint32_t kWordsPerColor = sizeof(shared::FilmColor) / sizeof(std::uint32_t);
constexpr std::uint32_t kWordsPerSum = 3;

// "scene NAME", "layer NAME 0|1", "set NAME=VALUE", "count KEY=NUMBER", one per line.
std::string textOf(const Checkpoint& checkpoint) {
    std::string text = "scene " + checkpoint.identity.scene + '\n';
    for (const LayerKind& layer : checkpoint.film.layers) {
        text += "layer " + layer.name + (layer.isLight ? " 1\n" : " 0\n");
    }
    for (const auto& [name, value] : checkpoint.identity.settings) {
        text += "set " + name + '=' + value + '\n';
    }
    for (const CounterRow& row : kCounters) {
        text += "count " + std::string(row.key) + '=' + std::to_string(checkpoint.counts[row.counter]) + '\n';
    }
    return text;
}

// Word `word` of a layer's sums: three channels per pixel.
std::vector<std::uint32_t> plane(std::span<const shared::FilmColor> sums, std::uint32_t word) {
    std::vector<std::uint32_t> words;
    words.reserve(3 * sums.size());
    for (const shared::FilmColor& color : sums) {
        const auto all = std::bit_cast<std::array<std::uint32_t, kWordsPerColor>>(color);
        for (std::uint32_t channel = 0; channel < 3; ++channel) {
            words.push_back(all.at(kWordsPerSum * channel + word));
        }
    }
    return words;
}

// 32 pixels a word, the first in the lowest bit.
std::vector<std::uint32_t> packedBits(const std::vector<std::uint32_t>& values) {
    std::vector<std::uint32_t> words((values.size() + 31) / 32, 0);
    for (std::size_t i = 0; i < values.size(); ++i) {
        words[i / 32] |= values[i] << i % 32;
    }
    return words;
}

std::vector<std::uint32_t> unpackedBits(const std::vector<std::uint32_t>& words, std::size_t count) {
    std::vector<std::uint32_t> values(count);
    for (std::size_t i = 0; i < count; ++i) {
        values[i] = words[i / 32] >> i % 32 & 1U;
    }
    return values;
}

// Reads a file from its beginning; fails if it ends too early.
class Cursor {
public:
    Cursor(std::span<const std::byte> content, const std::string& name) : left_(content), name_(name) {}

    [[noreturn]] void fail(const std::string& what) const {
        throw Error(ExitCode::BadInput, SourceLocation{name_}, what, "write one with hyalite render --checkpoint");
    }

    std::span<const std::byte> bytes(std::size_t count) {
        if (count > left_.size()) {
            fail("checkpoint is corrupt: the file is truncated");
        }
        const auto taken = left_.first(count);
        left_ = left_.subspan(count);
        return taken;
    }
    template <class T>
    std::vector<T> array(std::size_t count) {
        const auto from =
            bytes(std::min(count, left_.size()) * sizeof(T)); // no overflow: each value takes at least one byte
        std::vector<T> values(count);
        if (count > 0) { // memcpy forbids a null source even for zero bytes
            std::memcpy(values.data(), from.data(), from.size());
        }
        return values;
    }
    template <class T>
    T value() {
        return array<T>(1).front();
    }
    [[nodiscard]] bool isAtEnd() const { return left_.empty(); }

private:
    std::span<const std::byte> left_;
    const std::string& name_;
};

void readCount(const std::string& key, const std::string& number, const Cursor& cursor, Counts& counts) {
    const auto row = std::ranges::find(kCounters, key, &CounterRow::key);
    if (row == kCounters.end()) {
        cursor.fail("checkpoint is from a different version of the program");
    }
    const char* const end = number.data() + number.size();
    const auto read = std::from_chars(number.data(), end, counts[row->counter]);
    if (read.ec != std::errc() || read.ptr != end) {
        cursor.fail("checkpoint is corrupt: invalid content");
    }
}

void readText(const std::string& text, const Cursor& cursor, Checkpoint& checkpoint) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t space = line.find(' ');
        const std::string kind = line.substr(0, space);
        const std::string rest = space == std::string::npos ? "" : line.substr(space + 1);
        const std::size_t equals = rest.find('=');
        if (kind == "scene") {
            checkpoint.identity.scene = rest;
        } else if (kind == "layer" && rest.size() > 2) {
            checkpoint.film.layers.push_back({rest.substr(0, rest.size() - 2), rest.ends_with(" 1")});
        } else if (kind == "set" && equals != std::string::npos) {
            const std::string name = rest.substr(0, equals);
            // The name in files that were written before the table of settings named every setting
            checkpoint.identity.settings.emplace_back(name == "integrator" ? "render.integrator" : name,
                                                      rest.substr(equals + 1));
        } else if (kind == "count" && equals != std::string::npos) {
            readCount(rest.substr(0, equals), rest.substr(equals + 1), cursor, checkpoint.counts);
        } else {
            cursor.fail("checkpoint is corrupt: invalid content");
        }
    }
}

void readSums(Cursor& cursor, std::span<shared::FilmColor> sums) {
    const std::size_t words = 3 * sums.size();
    const auto present = cursor.value<std::uint32_t>();
    // The low plane is always present: otherwise a short file could request much memory
    std::array<std::vector<std::uint32_t>, kWordsPerSum> planes;
    for (std::uint32_t word = 0; word < kWordsPerSum; ++word) {
        if (word == 0 || (present >> word & 1U) != 0) {
            planes.at(word) = cursor.array<std::uint32_t>(words);
        }
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        std::array<std::uint32_t, kWordsPerColor> all{};
        for (std::uint32_t word = 0; word < kWordsPerSum; ++word) {
            for (std::uint32_t channel = 0; channel < 3 && !planes.at(word).empty(); ++channel) {
                all.at(kWordsPerSum * channel + word) = planes.at(word)[3 * i + channel];
            }
        }
        sums[i] = std::bit_cast<shared::FilmColor>(all);
    }
}

void readPasses(Cursor& cursor, std::uint32_t ranges, PassSet& passes) {
    std::uint64_t from = 0;
    for (const PassRange& range : cursor.array<PassRange>(ranges)) {
        if (range.begin < from || range.end <= range.begin) {
            cursor.fail("checkpoint is corrupt: invalid content");
        }
        passes.add(range);
        from = std::uint64_t{range.end} + 1; // adjacent ranges would be one
    }
}

} // namespace

void writeCheckpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
    const FilmState& film = checkpoint.film;
    const std::string text = textOf(checkpoint);
    const std::vector<PassRange>& ranges = film.passes.ranges();
    Header header;
    header.resolution = film.resolution;
    header.layers = static_cast<std::uint32_t>(film.layers.size());
    header.ranges = static_cast<std::uint32_t>(ranges.size());
    header.textBytes = static_cast<std::uint32_t>(text.size());
    header.seconds = checkpoint.seconds;
    writeFileAtomically(path, [&](const WriteBytes& write) {
        std::uint64_t checksum = kFnvStart;
        const auto append = [&](std::span<const std::byte> bytes) {
            checksum = fnv(bytes, checksum);
            write(bytes);
        };
        append(std::as_bytes(std::span(&header, 1)));
        append(std::as_bytes(std::span(text)));
        append(std::as_bytes(std::span(ranges)));
        append(std::as_bytes(std::span(film.faults)));
        const std::size_t pixels = std::size_t{film.resolution.x} * film.resolution.y;
        for (const std::vector<shared::FilmColor>& sums : film.sums) {
            for (std::size_t layer = 0; layer < film.layers.size(); ++layer) {
                std::array<std::vector<std::uint32_t>, kWordsPerSum> planes;
                std::uint32_t present = 1;
                for (std::uint32_t word = 0; word < kWordsPerSum; ++word) {
                    planes.at(word) = plane(std::span(sums).subspan(layer * pixels, pixels), word);
                    present |=
                        std::ranges::all_of(planes.at(word), [](std::uint32_t w) { return w == 0; }) ? 0U : 1U << word;
                }
                append(std::as_bytes(std::span(&present, 1)));
                for (std::uint32_t word = 0; word < kWordsPerSum; ++word) {
                    if ((present >> word & 1U) != 0) {
                        append(std::as_bytes(std::span(planes.at(word))));
                    }
                }
            }
        }
        const std::vector<std::uint32_t> sought = packedBits(film.sought);
        append(std::as_bytes(std::span(sought)));
        write(std::as_bytes(std::span(&checksum, 1)));
    });
}

Checkpoint parseCheckpoint(std::span<const std::byte> content, const std::string& name) {
    Cursor cursor(content, name);
    if (content.size() < sizeof(Header) + sizeof(std::uint64_t)) {
        cursor.fail("not a checkpoint file");
    }
    const auto header = cursor.value<Header>();
    if (!std::equal(kMagic.begin(), kMagic.end() - 1, header.magic.begin())) {
        cursor.fail("not a checkpoint file");
    }
    if (header.magic != kMagic) {
        cursor.fail("checkpoint is from a different version of the program");
    }
    std::uint64_t checksum = 0;
    std::memcpy(&checksum, content.last(sizeof checksum).data(), sizeof checksum);
    if (checksum != fnv(content.first(content.size() - sizeof checksum))) {
        cursor.fail("checkpoint is corrupt: checksum mismatch");
    }
    Checkpoint checkpoint;
    checkpoint.seconds = header.seconds;
    FilmState& film = checkpoint.film;
    film.resolution = header.resolution;
    const auto text = cursor.bytes(header.textBytes);
    readText({reinterpret_cast<const char*>(text.data()), text.size()}, cursor, checkpoint);
    readPasses(cursor, header.ranges, film.passes);
    const std::uint64_t pixels = std::uint64_t{film.resolution.x} * film.resolution.y;
    if (header.layers != film.layers.size() || header.layers == 0 || header.layers > kMostLayers || pixels == 0 ||
        header.ranges == 0 || pixels > content.size()) { // each pixel takes at least a byte
        cursor.fail("checkpoint is corrupt: invalid content");
    }
    film.faults = cursor.array<FilmFault>(film.layers.size() * shared::kFilmFaults);
    // The low words alone take a third of the sums' size
    if (pixels * header.layers > content.size()) {
        cursor.fail("checkpoint is corrupt: the file is truncated");
    }
    for (std::vector<shared::FilmColor>& sums : film.sums) {
        sums.resize(header.layers * pixels);
        for (std::size_t layer = 0; layer < header.layers; ++layer) {
            readSums(cursor, std::span(sums).subspan(layer * pixels, pixels));
        }
    }
    film.sought = unpackedBits(cursor.array<std::uint32_t>((pixels + 31) / 32), pixels);
    static_cast<void>(cursor.bytes(sizeof checksum));
    if (!cursor.isAtEnd()) {
        cursor.fail("checkpoint is corrupt: the file is longer than its content");
    }
    return checkpoint;
}

Checkpoint readCheckpoint(const std::filesystem::path& path) {
    const std::string file = readInputFile(path, kLargestFile, "checkpoint", SourceLocation{path.string()});
    return parseCheckpoint(std::as_bytes(std::span(file)), path.string());
}

void addCheckpoint(Checkpoint& whole, const Checkpoint& part, const std::string& name) {
    const auto fail = [&](const std::string& what, const std::string& hint) {
        throw Error(ExitCode::BadInput, SourceLocation{name}, what, hint);
    };
    const std::string differs = difference(part.identity, whole.identity);
    const auto sameLayer = [](const LayerKind& a, const LayerKind& b) {
        return a.name == b.name && a.isLight == b.isLight;
    };
    if (!differs.empty() || part.film.resolution != whole.film.resolution ||
        !std::ranges::equal(part.film.layers, whole.film.layers, sameLayer)) {
        fail("from a different render: " + (differs.empty() ? "the layers differ" : differs),
             "merged parts must have the same scene, settings and shaders");
    }
    for (const PassRange& range : part.film.passes.ranges()) {
        if (const auto common = whole.film.passes.common(range)) {
            fail("passes " + PassSet({*common}).text() + " occur twice", "omit one of the parts");
        }
    }
    addFilm(whole.film, part.film);
    whole.seconds += part.seconds;
    whole.counts += part.counts;
}

} // namespace hyalite::render
