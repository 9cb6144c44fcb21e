// See key_text.h.
#include "describe/key_text.h"

#include "base/numbers.h"
#include "scene/model/scene_limits.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace hyalite::describe {
namespace {

std::string jsonText(std::string_view text) {
    return nlohmann::json(text).dump();
}

bool hasBounds(const Range& range) {
    return range.low != 0 || range.high != 0;
}

// Every coordinate has this range, so the tables omit it.
bool isAnyCoordinate(const KeyDoc& key) {
    return key.type == KeyType::Vector && key.range.low == -kLargestLength && key.range.high == kLargestLength;
}

std::string interval(const Range& range) {
    return (range.lowIncluded ? '[' : '(') + shortNumber(range.low) + ", " + shortNumber(range.high) +
           (range.highIncluded ? ']' : ')');
}

// The schema of one number, without braces.
std::string numberSchema(std::string_view type, const Range& range) {
    std::string schema = "\"type\": " + jsonText(type);
    if (hasBounds(range)) {
        schema += std::string(range.lowIncluded ? ", \"minimum\": " : ", \"exclusiveMinimum\": ") +
                  shortNumber(range.low) + (range.highIncluded ? ", \"maximum\": " : ", \"exclusiveMaximum\": ") +
                  shortNumber(range.high);
    }
    return range.orZero ? "\"anyOf\": [{\"const\": 0}, {" + schema + "}]" : schema;
}

std::string arraySchema(std::string_view type, const Range& range, int count) {
    const std::string n = std::to_string(count);
    return "\"type\": \"array\", \"items\": {" + numberSchema(type, range) + "}, \"minItems\": " + n +
           ", \"maxItems\": " + n;
}

std::string colorSchemas(const Range& range) {
    return '{' + numberSchema("number", range) + "}, {" + arraySchema("number", range, 3) + '}';
}

std::string wordsSchema(std::span<const std::string_view> words) {
    std::string schema;
    for (const std::string_view word : words) {
        schema += (schema.empty() ? "" : ", ") + jsonText(word);
    }
    return "\"enum\": [" + schema + ']';
}

// The schema of the key's value, without braces.
std::string valueSchema(const KeyDoc& key) {
    switch (key.type) {
    case KeyType::Number:
        return numberSchema("number", key.range);
    case KeyType::WholeNumber:
        return numberSchema("integer", key.range);
    case KeyType::Flag:
        return "\"type\": \"boolean\"";
    case KeyType::Word:
        return wordsSchema(key.words);
    case KeyType::Text:
        if (!key.schema.empty()) {
            break;
        }
        return R"("type": ["string", "number", "boolean"])"; // YAML reads the name 12 as a number
    case KeyType::Vector:
        return isAnyCoordinate(key) ? R"("$ref": "#/$defs/vector")" : arraySchema("number", key.range, 3);
    case KeyType::Color:
        return "\"anyOf\": [" + colorSchemas(key.range) + ']';
    case KeyType::TexturedColor:
        return "\"anyOf\": [" + colorSchemas(key.range) + R"(, {"$ref": "#/$defs/textureReference"}])";
    case KeyType::WholePair:
        return arraySchema("integer", key.range, 2);
    case KeyType::Other:
        break;
    }
    const std::size_t open = key.schema.find('{');
    const std::size_t close = key.schema.rfind('}');
    return open == std::string_view::npos ? "" : std::string(key.schema.substr(open + 1, close - open - 1));
}

// The default as JSON; empty if it is not JSON.
std::string defaultSchema(const KeyDoc& key) {
    const std::string_view text = key.defaultText;
    if (key.type == KeyType::Word) {
        return std::ranges::find(key.words, text) == key.words.end() ? "" : jsonText(text);
    }
    if (key.type == KeyType::Text || text.empty()) {
        return {};
    }
    if (nlohmann::json::accept(text)) {
        return std::string(text);
    }
    const std::size_t slash = text.find('/');
    const auto over = parseNumber(text.substr(0, slash));
    const auto under = slash == std::string_view::npos ? std::nullopt : parseNumber(text.substr(slash + 1));
    return over && under ? shortNumber(*over / *under) : "";
}

} // namespace

std::string shortNumber(double value) {
    std::string text = numberText(value);
    const std::size_t e = text.find('e');
    if (e == std::string::npos) {
        return text;
    }
    const std::size_t digits = text.find_first_not_of("+-0", e + 1);
    return text.substr(0, e + 1) + (text[e + 1] == '-' ? "-" : "") + text.substr(digits);
}

std::string typeText(const KeyDoc& key) {
    if (!key.typeText.empty()) {
        return std::string(key.typeText);
    }
    switch (key.type) {
    case KeyType::Number:
        return "number";
    case KeyType::WholeNumber:
        return "whole number";
    case KeyType::Flag:
        return "true or false";
    case KeyType::Word:
    case KeyType::Text:
        return "text";
    case KeyType::Vector:
        return "vector";
    case KeyType::Color:
        return "colour";
    case KeyType::TexturedColor:
        return "textured colour";
    case KeyType::WholePair:
        return "two whole numbers";
    case KeyType::Other:
        break;
    }
    return {};
}

std::string rangeText(const KeyDoc& key) {
    if (!key.rangeText.empty()) {
        return std::string(key.rangeText);
    }
    if (key.type == KeyType::Word) {
        std::string words;
        for (const std::string_view word : key.words) {
            words += (words.empty() ? "`" : ", `") + std::string(word) + '`';
        }
        return words;
    }
    if (!hasBounds(key.range) || isAnyCoordinate(key)) {
        return {};
    }
    const bool isOne = key.type == KeyType::Number || key.type == KeyType::WholeNumber;
    return (key.range.orZero ? "0, or " : "") + std::string(isOne ? "" : "each ") + interval(key.range);
}

std::vector<std::string> schemaMembers(const KeyDoc& key) {
    std::vector<std::string> members;
    std::string description = plainText(key.text);
    if (!key.range.unit.empty()) {
        description += (description.empty() ? "[" : " [") + std::string(key.range.unit) + ']';
    }
    if (!description.empty()) {
        members.push_back("\"description\": " + jsonText(description));
    }
    members.push_back(valueSchema(key));
    if (const std::string value = defaultSchema(key); !value.empty()) {
        members.push_back("\"default\": " + value);
    }
    return members;
}

} // namespace hyalite::describe
