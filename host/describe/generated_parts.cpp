// See generated_parts.h.
#include "describe/generated_parts.h"

#include "base/error.h"
#include "describe/key_text.h"

#include <algorithm>

namespace hyalite::describe {
namespace {

constexpr std::size_t kWidth = 120;

// With the indentation of definitions in the file.
std::string definitionHead(const std::string& name) {
    return "\n    \"" + name + "\": {";
}

std::string row(const std::vector<std::string>& cells) {
    std::string line = "|";
    for (const std::string& cell : cells) {
        line += cell.empty() ? " |" : ' ' + cell + " |";
    }
    return line + '\n';
}

// A row of a table of types.
std::string typeRow(const std::string& type, const KeyDoc& key) {
    return row({type, '`' + std::string(key.name) + '`', typeText(key), std::string(key.range.unit),
                std::string(key.defaultText), rangeText(key), std::string(key.text)});
}

// The place of the definition's head; npos if the schema has no such definition.
std::size_t findDefinition(const std::string& schema, const std::string& name) {
    const std::size_t definitions = schema.find("\"$defs\"");
    return definitions == std::string::npos ? definitions : schema.find(definitionHead(name), definitions);
}

// "NAME": {members}, on one line if they fit, else the description and the rest on lines of their own.
std::string property(const std::string& name, const std::vector<std::string>& members) {
    const std::string indent(8, ' ');
    std::string all;
    for (const std::string& member : members) {
        all += (all.empty() ? "" : ", ") + member;
    }
    const std::string head = indent + '"' + name + "\": {";
    if (head.size() + all.size() + 2 <= kWidth) { // } and a comma
        return head + all + '}';
    }
    const bool isDescribed = members.front().starts_with("\"description\"");
    std::string rest;
    for (auto member = members.begin() + (isDescribed ? 1 : 0); member != members.end(); ++member) {
        rest += (rest.empty() ? "" : ", ") + *member;
    }
    return head + '\n' + (isDescribed ? indent + "  " + members.front() + ",\n" : "") + indent + "  " + rest + '\n' +
           indent + '}';
}

// {"const": "a"} or {"enum": ["a", "b"]}, without braces.
std::string typeSchema(std::string_view type, std::span<const std::string_view> types) {
    if (types.size() < 2) {
        return "\"const\": \"" + std::string(type) + '"';
    }
    std::string words;
    for (const std::string_view word : types) {
        words += (words.empty() ? "\"" : ", \"") + std::string(word) + '"';
    }
    return "\"enum\": [" + words + ']';
}

// The end of the JSON value that begins at `start` with a brace: one past its closing brace.
std::size_t endOfObject(const std::string& json, std::size_t start) {
    int depth = 0;
    bool inText = false;
    for (std::size_t i = start; i < json.size(); ++i) {
        if (inText) {
            if (json[i] == '\\') {
                ++i; // the character that it escapes
            } else {
                inText = json[i] != '"';
            }
        } else if (json[i] == '"') {
            inText = true;
        } else if (json[i] == '{') {
            ++depth;
        } else if (json[i] == '}' && --depth == 0) {
            return i + 1;
        }
    }
    throw Error(ExitCode::BadInput, "the JSON schema ends inside an object");
}

} // namespace

std::string keyTable(std::span<const KeyDoc> keys, const std::string& extraHead,
                     const std::vector<std::string>& extra) {
    std::vector<std::string> heads{"key", "type", "unit", "default", "range"};
    if (!extraHead.empty()) {
        heads.push_back(extraHead);
    }
    heads.emplace_back("meaning");
    std::string table = row(heads) + '|';
    for (std::size_t i = 0; i < heads.size(); ++i) {
        table += "---|";
    }
    table += '\n';
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const KeyDoc& key = keys[i];
        std::vector<std::string> cells{'`' + std::string(key.name) + '`', typeText(key), std::string(key.range.unit),
                                       std::string(key.defaultText), rangeText(key)};
        if (!extraHead.empty()) {
            cells.push_back(extra.at(i));
        }
        cells.emplace_back(key.text);
        table += row(cells);
    }
    return table;
}

std::string typeTable(std::span<const MapDoc> types, std::span<const KeyDoc> ofAll) {
    const auto isOfAll = [&](const KeyDoc& key) {
        return std::ranges::find(ofAll, key.name, &KeyDoc::name) != ofAll.end();
    };
    std::string table =
        row({"type", "key", "kind", "unit", "default", "range", "meaning"}) + "|---|---|---|---|---|---|---|\n";
    for (const MapDoc& type : types) {
        std::string name = '`' + std::string(type.type) + '`';
        if (type.keys.empty()) {
            table += row({name, "", "", "", "", "", std::string(type.text)});
        }
        for (const KeyDoc& key : type.keys) {
            if (!isOfAll(key)) {
                table += typeRow(name, key);
                name.clear(); // only in the first row
            }
        }
    }
    for (const KeyDoc& key : ofAll) {
        table += typeRow("all", key);
    }
    return table;
}

std::string withGenerated(const std::string& text, const std::string& name, const std::string& part) {
    const std::string mark = "<!-- generated: " + name + " -->\n";
    const std::size_t start = text.find(mark);
    const std::size_t end = start == std::string::npos ? start : text.find("<!-- end -->", start);
    if (end == std::string::npos) {
        throw Error(ExitCode::BadInput, "missing marks <!-- generated: " + name + " --> and <!-- end -->");
    }
    return text.substr(0, start + mark.size()) + part + text.substr(end);
}

std::string definition(const MapDoc& map, std::span<const std::string_view> types) {
    std::string required = map.type.empty() ? "" : "\"type\"";
    for (const KeyDoc& key : map.keys) {
        if (key.required) {
            required += (required.empty() ? "\"" : ", \"") + std::string(key.name) + '"';
        }
    }
    const std::string indent(6, ' ');
    std::string text = "{\n" + indent + "\"type\": \"object\",\n";
    if (!required.empty()) {
        text += indent + "\"required\": [" + required + "],\n";
    }
    if (!map.rules.empty()) {
        const std::size_t open = map.rules.find('{') + 1;
        text += indent + std::string(map.rules.substr(open, map.rules.rfind('}') - open)) + ",\n";
    }
    text += indent + "\"additionalProperties\": false,\n" + indent + "\"properties\": {\n";
    std::vector<std::string> properties;
    if (!map.type.empty()) {
        properties.push_back(property("type", {typeSchema(map.type, types)}));
    }
    for (const KeyDoc& key : map.keys) {
        properties.push_back(property(std::string(key.name), schemaMembers(key)));
    }
    for (std::size_t i = 0; i < properties.size(); ++i) {
        text += properties[i] + (i + 1 < properties.size() ? ",\n" : "\n");
    }
    return text + indent + "}\n    }";
}

std::string definition(const KeyDoc& key) {
    std::string all;
    for (const std::string& member : schemaMembers(key)) {
        all += (all.empty() ? "\n      " : ",\n      ") + member;
    }
    return '{' + all + "\n    }";
}

std::string withPlaceFor(const std::string& schema, const std::string& name, const std::string& next) {
    if (findDefinition(schema, name) != std::string::npos) {
        return schema;
    }
    const std::size_t place = findDefinition(schema, next);
    if (place == std::string::npos) {
        throw Error(ExitCode::BadInput, "the JSON schema has no definition '" + next + "'");
    }
    return schema.substr(0, place) + definitionHead(name) + "}," + schema.substr(place);
}

std::string withDefinition(const std::string& schema, const std::string& name, const std::string& part) {
    const std::size_t start = findDefinition(schema, name);
    if (start == std::string::npos) {
        throw Error(ExitCode::BadInput, "the JSON schema has no definition '" + name + "' to replace");
    }
    const std::size_t brace = start + definitionHead(name).size() - 1;
    return schema.substr(0, brace) + part + schema.substr(endOfObject(schema, brace));
}

} // namespace hyalite::describe
