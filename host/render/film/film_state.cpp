#include "render/film/film_state.h"

#include <algorithm>
#include <string_view>

namespace hyalite::render {

void PassSet::add(PassRange range) {
    const auto after = std::ranges::lower_bound(ranges_, range.begin, {}, &PassRange::begin);
    auto place = ranges_.insert(after, range);
    if (place != ranges_.begin() && std::prev(place)->end == place->begin) {
        std::prev(place)->end = place->end;
        place = std::prev(ranges_.erase(place));
    }
    if (const auto next = std::next(place); next != ranges_.end() && place->end == next->begin) {
        place->end = next->end;
        ranges_.erase(next);
    }
}

bool PassSet::contains(std::uint32_t pass) const {
    return std::ranges::any_of(ranges_, [&](const PassRange& r) { return r.begin <= pass && pass < r.end; });
}

std::optional<PassRange> PassSet::common(const PassRange& range) const {
    for (const PassRange& own : ranges_) {
        const PassRange both{std::max(own.begin, range.begin), std::min(own.end, range.end)};
        if (both.begin < both.end) {
            return both;
        }
    }
    return std::nullopt;
}

std::uint32_t PassSet::countWithin(const PassRange& range) const {
    std::uint32_t passes = 0;
    for (const PassRange& own : ranges_) {
        const std::uint32_t begin = std::max(own.begin, range.begin);
        passes += std::max(begin, std::min(own.end, range.end)) - begin;
    }
    return passes;
}

std::uint32_t PassSet::count() const {
    std::uint32_t passes = 0;
    for (const PassRange& range : ranges_) {
        passes += range.end - range.begin;
    }
    return passes;
}

std::uint32_t PassSet::count(std::uint32_t sequence) const {
    // Of the passes [0, n), n / 2 belong to each sequence, rounded up for sequence 0
    const auto below = [&](std::uint32_t n) { return n / 2 + (sequence == 0 ? n % 2 : 0); };
    static_assert(shared::kCameraSequences == 2);
    std::uint32_t passes = 0;
    for (const PassRange& range : ranges_) {
        passes += below(range.end) - below(range.begin);
    }
    return passes;
}

std::string PassSet::text() const {
    std::string text;
    for (const PassRange& range : ranges_) {
        text += (text.empty() ? "" : ", ") + std::to_string(range.begin) + ':' + std::to_string(range.end);
    }
    return text;
}

void addFault(FilmFault& fault, const FilmFault& more) {
    if (more.count == 0) {
        return;
    }
    if (fault.count == 0 || more.pass < fault.pass) {
        fault.pass = more.pass;
        fault.pixel = more.pixel;
    }
    fault.count += more.count;
}

void addFilm(FilmState& film, const FilmState& part) {
    const std::size_t pixels = std::size_t{film.resolution.x} * film.resolution.y;
    for (std::size_t i = 0; i < film.faults.size(); ++i) {
        addFault(film.faults[i], part.faults[i]);
    }
    for (std::size_t sequence = 0; sequence < film.sums.size(); ++sequence) {
        for (std::size_t i = 0; i < film.sums.at(sequence).size(); ++i) {
            const auto add = [&](shared::FilmSum& sum, const shared::FilmSum& more) {
                const shared::FilmSum both = shared::filmAdd(sum, more);
                if (shared::filmIsLess(both, sum) != 0) {
                    addFault(film.faults[i / pixels * shared::kFilmFaults + shared::kFilmTooBright],
                             {1, part.passes.ranges().front().begin, static_cast<std::uint32_t>(i % pixels)});
                    return;
                }
                sum = both;
            };
            shared::FilmColor& color = film.sums.at(sequence)[i];
            const shared::FilmColor& more = part.sums.at(sequence)[i];
            add(color.red, more.red);
            add(color.green, more.green);
            add(color.blue, more.blue);
        }
    }
    for (std::size_t i = 0; i < pixels; ++i) {
        film.sought[i] |= part.sought[i];
    }
    for (const PassRange& range : part.passes.ranges()) {
        film.passes.add(range);
    }
}

std::vector<std::string> faultWarnings(const std::vector<FilmFault>& faults, const std::vector<LayerKind>& layers,
                                       glm::uvec2 resolution, const std::string& command) {
    constexpr std::array<std::string_view, shared::kFilmFaults> kKinds{"not a number", "infinite", "negative",
                                                                       "too bright for the film"};
    std::vector<std::string> warnings;
    for (std::size_t i = 0; i < faults.size(); ++i) {
        const FilmFault& fault = faults[i];
        if (fault.count > 0) {
            const std::string pixel =
                std::to_string(fault.pixel % resolution.x) + ',' + std::to_string(fault.pixel / resolution.x);
            warnings.push_back(std::to_string(fault.count) + (fault.count == 1 ? " value" : " values") + " of layer '" +
                               layers[i / shared::kFilmFaults].name + "' " + (fault.count == 1 ? "was " : "were ") +
                               std::string(kKinds.at(i % shared::kFilmFaults)) + " and left out, the first at pixel " +
                               pixel + " of pass " + std::to_string(fault.pass) + " (look at it with: " + command +
                               " --pixel " + pixel + " --pass " + std::to_string(fault.pass) + ")");
        }
    }
    return warnings;
}

} // namespace hyalite::render
