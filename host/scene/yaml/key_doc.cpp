#include "scene/yaml/key_doc.h"

#include <algorithm>

namespace hyalite {

std::string plainText(std::string_view markdown) {
    std::string plain;
    for (std::size_t i = 0; i < markdown.size(); ++i) {
        if (markdown[i] == '`') {
            continue;
        }
        const std::size_t closed = markdown.find(']', i);
        const std::size_t end = markdown.find(')', i);
        if (markdown[i] == '[' && markdown.substr(std::min(closed, markdown.size()), 2) == "](" &&
            end != std::string_view::npos) {
            plain += plainText(markdown.substr(i + 1, closed - i - 1));
            i = end;
            continue;
        }
        plain += markdown[i];
    }
    return plain;
}

} // namespace hyalite
