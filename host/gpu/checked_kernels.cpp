// Rewrites GLSL by matching brackets: enough for our shaders, and a kernel that it breaks fails to compile.
#include "gpu/checked_kernels.h"

#include <cctype>
#include <regex>
#include <set>
#include <utility>

namespace hyalite::gpu {
namespace {

bool isWord(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Position of the bracket that closes the one at `open`.
std::size_t closing(const std::string& text, std::size_t open) {
    const char opens = text[open];
    const char closes = opens == '[' ? ']' : ')';
    int depth = 0;
    for (std::size_t i = open; i < text.size(); ++i) {
        depth += text[i] == opens ? 1 : text[i] == closes ? -1 : 0;
        if (depth == 0) {
            return i;
        }
    }
    return text.size() - 1;
}

// Start of the expression that ends before `end`: names, dots, and brackets with their contents.
std::size_t beginningOf(const std::string& text, std::size_t end) {
    std::size_t begin = end;
    while (begin > 0) {
        const char c = text[begin - 1];
        if (isWord(c) || c == '.') {
            --begin;
        } else if (c == ']' || c == ')') {
            int depth = 0;
            do {
                --begin;
                depth += text[begin] == ']' || text[begin] == ')'   ? 1
                         : text[begin] == '[' || text[begin] == '(' ? -1
                                                                    : 0;
            } while (depth > 0 && begin > 0);
        } else {
            break;
        }
    }
    return begin;
}

// Names of the arrays that the text declares: `uint a[8];`, `LeafState b[kMany];`.
std::set<std::string> declaredArrays(const std::string& text) {
    static const std::regex declaration(R"((?:^|[;{}\n])\s*[A-Za-z_]\w*\s+([A-Za-z_]\w*)\[[^\]]+\]\s*;)");
    std::set<std::string> names;
    for (std::sregex_iterator found(text.begin(), text.end(), declaration); found != std::sregex_iterator(); ++found) {
        names.insert((*found)[1].str());
    }
    return names;
}

class Rewriter {
public:
    Rewriter(std::string line, const std::set<std::string>& arrays, std::string site)
        : text_(std::move(line)), arrays_(arrays), site_(std::move(site)) {}

    std::string run() {
        for (std::size_t i = 0; i < text_.size();) {
            if (text_.compare(i, 4, ".at[") == 0) {
                i = rewriteDeviceArray(i);
            } else if (text_.compare(i, 11, "texelFetch(") == 0 && (i == 0 || !isWord(text_[i - 1]))) {
                i = rewriteTexel(i);
            } else if (text_[i] == '[') {
                i = rewritePrivateArray(i);
            } else {
                ++i;
            }
        }
        return text_;
    }

private:
    // Each returns the position to continue at: after the inserted text, at the index, which may contain more accesses.
    std::size_t rewriteDeviceArray(std::size_t dot) {
        const std::size_t open = dot + 3;
        const std::size_t close = closing(text_, open);
        const std::size_t begin = beginningOf(text_, dot);
        const std::string array = text_.substr(begin, dot - begin);
        const std::string index = text_.substr(open + 1, close - open - 1);
        const std::string head = '(' + array + " + checkedIndex(uvec2(" + array + "), uvec2(" + array + " + 1), uint(";
        text_.replace(begin, close + 1 - begin,
                      head + index + "), " + site_ + ")).at [0]"); // the space keeps it from being rewritten again
        return begin + head.size();
    }
    std::size_t rewriteTexel(std::size_t call) {
        const std::size_t open = call + 10;
        const std::size_t close = closing(text_, open);
        const std::size_t comma = text_.find(',', open);
        const std::string table = text_.substr(open + 1, comma - open - 1);
        const std::string index = text_.substr(comma + 1, close - comma - 1);
        const std::string head = "texelFetch(" + table + ", checkedTexel(" + table + ", int(";
        text_.replace(call, close + 1 - call, head + index + "), " + site_ + "))");
        return call + head.size();
    }
    std::size_t rewritePrivateArray(std::size_t open) {
        const std::size_t begin = beginningOf(text_, open);
        const std::string name = text_.substr(begin, open - begin);
        const std::size_t close = closing(text_, open);
        // A declaration has its type before the name
        const std::size_t before = text_.find_last_not_of(" \t", begin == 0 ? std::string::npos : begin - 1);
        const bool declares = begin > 0 && before != std::string::npos && before + 1 < begin && isWord(text_[before]) &&
                              text_.compare(before < 5 ? 0 : before - 5, 6, "return") != 0;
        if (!arrays_.contains(name) || declares) {
            return open + 1;
        }
        const std::string head = name + "[checkedEntry(uint(";
        const std::string index = text_.substr(open + 1, close - open - 1);
        text_.replace(begin, close + 1 - begin, head + index + "), uint(" + name + ".length()), " + site_ + ")]");
        return begin + head.size();
    }

    std::string text_;
    const std::set<std::string>& arrays_;
    std::string site_;
};

// Statements may span lines, and glslang counts lines: the rewritten text has as many.
bool isDirective(const std::string& line) {
    const std::size_t first = line.find_first_not_of(" \t");
    return first != std::string::npos && (line[first] == '#' || line.compare(first, 2, "//") == 0);
}

} // namespace

std::string withBoundChecks(const std::string& text, std::uint32_t file) {
    const std::set<std::string> arrays = declaredArrays(text);
    std::string rewritten;
    std::string piece; // lines up to matching brackets
    std::uint32_t line = 0;
    std::uint32_t firstLine = 0;
    const auto flush = [&] {
        rewritten += Rewriter(piece, arrays, std::to_string(firstLine + (file << kSiteLineBits)) + 'u').run();
        piece.clear();
    };
    const auto depth = [](const std::string& part) {
        int open = 0;
        for (const char c : part) {
            open += c == '(' || c == '[' ? 1 : c == ')' || c == ']' ? -1 : 0;
        }
        return open;
    };
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
        const std::string whole = text.substr(begin, end - begin);
        begin = end;
        ++line;
        if (piece.empty() && isDirective(whole)) {
            rewritten += whole;
            continue;
        }
        firstLine = piece.empty() ? line : firstLine;
        const std::size_t comment = whole.find("//"); // it may contain brackets
        piece += comment == std::string::npos ? whole : whole.substr(0, comment) + '\n';
        if (depth(piece) <= 0) {
            flush();
        }
    }
    flush();
    return rewritten;
}

} // namespace hyalite::gpu
