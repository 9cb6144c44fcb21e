// See spelling.h.
#include "base/spelling.h"

#include <algorithm>
#include <vector>

namespace hyalite {

std::string inQuotes(std::string_view text) {
    constexpr std::size_t kLongest = 60;
    std::string shown(text.substr(0, kLongest));
    std::replace_if(
        shown.begin(), shown.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
    return '\'' + shown + (text.size() > kLongest ? "...'" : "'");
}

std::string lowerCase(std::string_view text) {
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return lower;
}

std::size_t editDistance(std::string_view a, std::string_view b) {
    // Rows i-2, i-1 and i of the table: row[j] is the distance from a's first i letters to b's first j.
    std::vector<std::size_t> beforeLast(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) {
        row[j] = j;
    }
    for (std::size_t i = 1; i <= a.size(); ++i) {
        beforeLast.swap(last);
        last.swap(row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replace = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, replace});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], beforeLast[j - 2] + 1);
            }
        }
    }
    return row[b.size()];
}

std::string spellingHint(std::string_view word, std::span<const std::string> known) {
    constexpr std::size_t kLongestWord = 64; // the distance costs the product of both lengths
    if (word.size() <= kLongestWord) {
        const std::string* nearest = nullptr;
        std::size_t nearestDistance = std::max<std::size_t>(1, word.size() / 3) + 1;
        for (const std::string& candidate : known) {
            if (candidate.size() > kLongestWord) {
                continue;
            }
            const std::size_t distance = editDistance(word, candidate);
            if (distance < nearestDistance && distance < candidate.size()) {
                nearest = &candidate;
                nearestDistance = distance;
            }
        }
        if (nearest != nullptr) {
            return "did you mean " + inQuotes(*nearest) + '?';
        }
    }

    constexpr std::size_t kMostListed = 32;
    if (known.empty() || known.size() > kMostListed) {
        return {};
    }
    std::string list = "known:";
    for (const std::string& candidate : known) {
        list += (list.back() == ':' ? " " : ", ") + candidate;
    }
    return list;
}

} // namespace hyalite
