// See gltf_json.h.
#include "scene/import/gltf_json.h"

#include "base/numbers.h"
#include "base/spelling.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace hyalite {

void GltfValue::fail(const std::string& what, const std::string& hint) const {
    throw Error(ExitCode::BadInput, SourceLocation{*file_, 0, 0}, (place_.empty() ? "" : place_ + ": ") + what, hint);
}

void GltfValue::expected(const std::string& what) const {
    std::string found;
    if (json_->is_array()) {
        found = "a list of " + std::to_string(json_->size());
    } else if (json_->is_object()) {
        found = "an object";
    } else if (json_->is_string()) {
        found = "the text " + inQuotes(text());
    } else {
        found = json_->dump();
    }
    fail("expected " + what + ", found " + found);
}

std::optional<GltfValue> GltfValue::find(const char* key) const {
    if (!json_->is_object()) {
        expected("an object");
    }
    const auto found = json_->find(key);
    if (found == json_->end()) {
        return std::nullopt;
    }
    return GltfValue(*found, *file_, place_.empty() ? key : place_ + '.' + key);
}

GltfValue GltfValue::require(const char* key) const {
    if (auto value = find(key)) {
        return *std::move(value);
    }
    fail("missing '" + std::string(key) + "'");
}

std::size_t GltfValue::size() const {
    if (!json_->is_array()) {
        expected("a list");
    }
    return json_->size();
}

GltfValue GltfValue::at(std::size_t index) const {
    if (index >= size()) {
        fail("index " + std::to_string(index) + " is out of range",
             "the list has " + std::to_string(size()) + " items, counted from 0");
    }
    return {(*json_)[index], *file_, place_ + '[' + std::to_string(index) + ']'};
}

const std::string& GltfValue::text() const {
    if (!json_->is_string()) {
        expected("text");
    }
    return json_->get_ref<const std::string&>();
}

bool GltfValue::truth() const {
    if (!json_->is_boolean()) {
        expected("true or false");
    }
    return json_->get<bool>();
}

double GltfValue::number(double low, double high) const {
    if (!json_->is_number()) {
        expected("a number");
    }
    const auto value = json_->get<double>();
    if (!(value >= low && value <= high)) {
        expected(low == -high ? "a finite number" : "a number in [" + numberText(low) + ", " + numberText(high) + ']');
    }
    return value;
}

std::vector<double> GltfValue::numbers(std::size_t count, double low, double high) const {
    if (size() != count) {
        fail("expected a list of " + std::to_string(count) + " numbers, found one of " + std::to_string(size()));
    }
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
        values.push_back(at(i).number(low, high));
    }
    return values;
}

std::uint64_t GltfValue::whole(std::uint64_t low, std::uint64_t high) const {
    // 2.0 is a whole number in JSON too.
    const double value = json_->is_number() ? json_->get<double>() : -1;
    if (!(value >= static_cast<double>(low) && value <= static_cast<double>(high)) || value != std::floor(value)) {
        expected("a whole number in [" + std::to_string(low) + ", " + std::to_string(high) + ']');
    }
    return static_cast<std::uint64_t>(value);
}

std::size_t GltfValue::index(const GltfValue& document, const char* name) const {
    const auto list = document.find(name);
    const std::size_t count = list ? list->size() : 0;
    const std::uint64_t value = whole();
    if (value >= count) {
        fail("index " + std::to_string(value) + " of '" + name + "' is out of range",
             "there are " + std::to_string(count) + ", counted from 0");
    }
    return static_cast<std::size_t>(value);
}

} // namespace hyalite
