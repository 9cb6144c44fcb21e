// A YAML document as a tree of plain values that know their place in the file. Built from yaml-cpp's parser events, not
// from its Node, which silently keeps duplicate keys, loses the place of a key and follows recursive aliases forever.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace hyalite {

struct YamlNode;
using YamlPointer = std::shared_ptr<const YamlNode>; // shared: an alias (*name) refers to the same value

struct YamlEntry {
    std::string key;
    int line = 0; // of the key
    int column = 0;
    YamlPointer value;
};

struct YamlNode {
    enum class Kind { Null, Scalar, List, Map };

    Kind kind = Kind::Null;
    int line = 0; // from 1; 0: not from a file
    int column = 0;
    std::string text;               // Scalar
    bool isQuoted = false;          // Scalar: "1" is text, 1 may be a number
    std::vector<YamlPointer> items; // List
    std::vector<YamlEntry> entries; // Map, in file order, no key twice
    std::size_t height = 1;         // levels of nesting, aliases expanded
    std::size_t size = 1;           // nodes, aliases expanded
};

// Parses exactly one YAML document. Throws Error(BadInput) with `file` and, if `hasLines`, the place: for syntax
// errors, no document or several, duplicate keys, keys that are not text, tags, a tree too deep or too large.
[[nodiscard]] YamlPointer parseYaml(std::string_view text, const std::string& file, bool hasLines = true);

} // namespace hyalite
