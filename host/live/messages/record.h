// Structs that travel as JSON objects. Each names its fields once, for writing and for reading alike.
#pragma once

#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>

namespace hyalite::live {

using Json = nlohmann::json;

// A struct with `static void fields(auto& self, auto&& field)` that calls field("key", self.member) for every member
// which travels.
template <class T>
concept Record = requires(T& record) { T::fields(record, [](const char*, auto&) {}); };

template <class T>
inline constexpr bool kIsOptional = false;
template <class T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

template <Record T>
void to_json(Json& json, const T& record) { // NOLINT(readability-identifier-naming): nlohmann looks for this name
    json = Json::object();
    T::fields(record, [&](const char* key, const auto& value) {
        if constexpr (kIsOptional<std::remove_cvref_t<decltype(value)>>) {
            json[key] = value ? Json(*value) : Json();
        } else {
            json[key] = value;
        }
    });
}

// Throws nlohmann's exceptions where a key is missing or a value has another type.
template <Record T>
void from_json(const Json& json, T& record) { // NOLINT(readability-identifier-naming): likewise
    T::fields(record, [&]<class Value>(const char* key, Value& value) {
        const Json& found = json.at(key);
        if constexpr (kIsOptional<Value>) {
            value.reset();
            if (!found.is_null()) {
                value = found.template get<typename Value::value_type>();
            }
        } else if constexpr (std::is_floating_point_v<Value>) {
            // JSON has neither NaN nor infinity: they are written as null
            value = found.is_null() ? std::numeric_limits<Value>::quiet_NaN() : found.template get<Value>();
        } else {
            found.get_to(value);
        }
    });
}

} // namespace hyalite::live
