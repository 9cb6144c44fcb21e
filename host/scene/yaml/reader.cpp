// See reader.h.
#include "scene/yaml/reader.h"

#include "base/spelling.h"

#include <algorithm>
#include <cmath>

namespace hyalite {

bool Range::contains(double value) const {
    if (orZero && value == 0) {
        return true;
    }
    return (lowIncluded ? value >= low : value > low) && (highIncluded ? value <= high : value < high);
}

std::string Range::text() const {
    const std::string tail = unit.empty() ? std::string() : ' ' + std::string(unit);
    return std::string(orZero ? "0 or " : "") + (lowIncluded ? "in [" : "in (") + numberText(low) + ", " +
           numberText(high) + (highIncluded ? ']' : ')') + tail;
}

void Value::fail(const std::string& what, const std::string& hint) const {
    throw Error(ExitCode::BadInput, where(), what, hint);
}

std::string Value::describe() const {
    switch (node_->kind) {
    case YamlNode::Kind::Null:
        return "nothing";
    case YamlNode::Kind::List:
        return "a list of " + std::to_string(node_->items.size());
    case YamlNode::Kind::Map:
        return "a map";
    case YamlNode::Kind::Scalar:
        break;
    }
    const bool isNumber = !node_->isQuoted && parseNumber(node_->text).has_value();
    return isNumber ? node_->text : "the text " + inQuotes(node_->text);
}

void Value::expected(const std::string& what, const std::string& hint) const {
    fail(inQuotes(name_) + " must be " + what + ", found " + describe(), hint);
}

std::string Value::text() const {
    if (node_->kind != YamlNode::Kind::Scalar || node_->text.empty()) {
        expected("text");
    }
    return node_->text;
}

std::vector<Value> Value::list() const {
    if (node_->kind != YamlNode::Kind::List) {
        expected("a list");
    }
    std::vector<Value> items;
    items.reserve(node_->items.size());
    for (const YamlPointer& item : node_->items) {
        items.emplace_back(*item, *file_, name_);
    }
    return items;
}

std::vector<Value> Value::list(std::size_t count) const {
    if (node_->kind != YamlNode::Kind::List || node_->items.size() != count) {
        expected("a list of " + std::to_string(count));
    }
    return list();
}

std::vector<double> Value::numbers(std::size_t count, const Range& each) const {
    if (node_->kind != YamlNode::Kind::List || node_->items.size() != count) {
        expected("a list of " + std::to_string(count) + " numbers");
    }
    std::vector<double> values;
    for (const Value& item : list()) {
        values.push_back(0);
        item.read(values.back(), each);
    }
    return values;
}

void Value::read(double& out, const Range& range) const {
    const auto number =
        node_->kind == YamlNode::Kind::Scalar && !node_->isQuoted ? parseNumber(node_->text) : std::nullopt;
    if (!number) {
        expected("a number");
    }
    if (!std::isfinite(*number)) {
        expected("a finite number");
    }
    if (!range.contains(*number)) {
        expected(range.text());
    }
    out = *number;
}

void Value::read(std::uint32_t& out, const Range& range) const {
    const auto number =
        node_->kind == YamlNode::Kind::Scalar && !node_->isQuoted ? parseWhole(node_->text) : std::nullopt;
    if (!number) {
        expected("a whole number " + range.text());
    }
    if (!range.contains(static_cast<double>(*number))) {
        expected(range.text());
    }
    out = static_cast<std::uint32_t>(*number);
}

void Value::read(bool& out) const {
    const bool isTrue = node_->kind == YamlNode::Kind::Scalar && node_->text == "true";
    if (node_->isQuoted || (!isTrue && node_->text != "false")) {
        expected("true or false");
    }
    out = isTrue;
}

void Value::read(glm::dvec3& out, const Range& each) const {
    const auto xyz = numbers(3, each);
    out = {xyz[0], xyz[1], xyz[2]};
}

void Value::read(glm::uvec2& out, const Range& each) const {
    if (node_->kind != YamlNode::Kind::List || node_->items.size() != 2) {
        expected("a list of 2 numbers");
    }
    glm::uvec2 value;
    list()[0].read(value.x, each);
    list()[1].read(value.y, each);
    out = value;
}

void Value::readColor(glm::dvec3& out, const Range& each) const {
    if (node_->kind == YamlNode::Kind::Scalar) {
        double gray = 0;
        read(gray, each);
        out = glm::dvec3(gray);
        return;
    }
    if (node_->kind != YamlNode::Kind::List || node_->items.size() != 3) {
        expected("one number or a list of 3 numbers");
    }
    read(out, each);
}

Reader::Reader(const Value& map) : map_(map) {
    if (map.node().kind == YamlNode::Kind::Null) {
        map.fail(inQuotes(map.name()) + " must be a map of keys, found nothing");
    }
    if (map.node().kind != YamlNode::Kind::Map) {
        map.fail(inQuotes(map.name()) + " must be a map of keys", "write {key: value, ...} or indented lines");
    }
}

std::optional<Value> Reader::find(std::string_view key) {
    asked_.emplace_back(key);
    for (const YamlEntry& entry : map_.node().entries) {
        if (entry.key == key) {
            return Value(*entry.value, map_.file(), entry.key);
        }
    }
    return std::nullopt;
}

Value Reader::require(std::string_view key) {
    if (const auto value = find(key)) {
        return *value;
    }
    // "raduis: 1" is a typing error, not a sphere without a radius.
    for (const YamlEntry& entry : map_.node().entries) {
        const bool asked = std::find(asked_.begin(), asked_.end(), entry.key) != asked_.end();
        const std::string wanted(key);
        if (!asked && spellingHint(entry.key, {&wanted, 1}).starts_with("did you mean")) {
            failUnknown(entry);
        }
    }
    map_.fail("missing key " + inQuotes(key) + " in " + inQuotes(map_.name()));
}

void Reader::finish() const {
    for (const YamlEntry& entry : map_.node().entries) {
        if (std::find(asked_.begin(), asked_.end(), entry.key) == asked_.end()) {
            failUnknown(entry);
        }
    }
}

void Reader::failUnknown(const YamlEntry& entry) const {
    throw Error(ExitCode::BadInput, SourceLocation{map_.file(), entry.line, entry.column},
                "unknown key " + inQuotes(entry.key) + " in " + inQuotes(map_.name()), spellingHint(entry.key, asked_));
}

void failUnknownWord(const Value& value, std::string_view kind, std::span<const std::string> known) {
    value.fail("unknown " + std::string(kind) + ' ' + inQuotes(value.text()), spellingHint(value.text(), known));
}

} // namespace hyalite
