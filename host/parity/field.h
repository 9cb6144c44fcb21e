// The fields that a kernel's check compares, each declared once: its name, how far the two sides may differ, and why.
#pragma once

#include "parity/tolerances.h"

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace hyalite::parity {

enum class Measure {
    Exact,     // integers, indices, decisions: equal or not
    Number,    // |a - b|
    Vector,    // |a - b|, of points and colours
    Direction, // the same for unit vectors: for small differences, the angle between them [rad]
};

// Lower bound on what an error is relative to.
enum class Scale {
    Value, // the twin's own value: its largest component
    One,   // 1
    Scene, // the largest coordinate of the scene and the camera [m]
};

// Identified by its address: answers refer to it by reference, so that no name can be mistyped.
struct Field {
    std::string_view name;
    Measure measure = Measure::Exact;
    const Tolerance* tolerance = nullptr;
    Scale scale = Scale::Value; // of errors
    std::string_view nearby;    // name of the cause if an input a few roundings away explains the difference
};

// Fields in the order in which they are compared, exact ones first. A check's fields derive from this and declare each
// as a reference:
//     struct HitFields : FieldSet<2> {
//         const Field& object = exact("object", kEdge);
//         const Field& t = number("t", kPosition, Scale::Scene);
//     };
//     constexpr HitFields kHit;
template <std::size_t kMost>
class FieldSet {
public:
    constexpr FieldSet() = default;
    FieldSet(const FieldSet&) = delete;
    FieldSet& operator=(const FieldSet&) = delete;

    [[nodiscard]] constexpr std::span<const Field> all() const { return std::span(fields_).first(size_); }

protected:
    ~FieldSet() = default;

    constexpr const Field& exact(std::string_view name, std::string_view nearby = {}) {
        return add({name, Measure::Exact, &kEqual, Scale::Value, nearby});
    }
    constexpr const Field& number(std::string_view name, const Tolerance& tolerance, Scale scale = Scale::Value,
                                  std::string_view nearby = kGrazing) {
        return add({name, Measure::Number, &tolerance, scale, nearby});
    }
    constexpr const Field& vector(std::string_view name, const Tolerance& tolerance, Scale scale = Scale::Value,
                                  std::string_view nearby = kGrazing) {
        return add({name, Measure::Vector, &tolerance, scale, nearby});
    }
    constexpr const Field& place(std::string_view name) { return vector(name, kPosition, Scale::Scene); }
    constexpr const Field& angle(std::string_view name, const Tolerance& tolerance = kDirection) {
        return add({name, Measure::Direction, &tolerance, Scale::One, kGrazing});
    }

private:
    constexpr const Field& add(const Field& field) {
        fields_[size_] = field;
        return fields_[size_++];
    }

    std::array<Field, kMost> fields_{};
    std::size_t size_ = 0;
};

} // namespace hyalite::parity
