// What two sides may differ by, field by field: one table for all stages, with a reason for every number.
#pragma once

#include <span>
#include <string_view>

namespace hyalite::parity {

enum class Measure {
    Exact,     // integers, indices, decisions: equal or not
    Number,    // |a - b|
    Vector,    // |a - b|, of points and colours
    Direction, // the same of unit vectors: for small differences the angle between them [rad]
};

// What an error is relative to, at least.
enum class Scale {
    Value, // the twin's own value: its largest component
    One,   // 1
    Scene, // the largest coordinate of the scene and the camera [m]
};

struct Tolerance {
    std::string_view stage; // a kernel's name
    std::string_view field;
    Measure measure = Measure::Exact;
    double relative = 0;          // largest error over the scale
    Scale scale = Scale::Value;   // of errors
    std::string_view reason = {}; // for the tolerance
    std::string_view nearby = {}; // what it is called where an input a few roundings away explains the difference
};

// All fields of a stage in the order in which they are looked at: the exact ones first. Empty: a stage without a twin.
[[nodiscard]] std::span<const Tolerance> tolerancesOf(std::string_view stage);

[[nodiscard]] std::span<const Tolerance> allTolerances();

// Of the elements of a stage, at most this share may differ by what a few roundings of the input explain.
inline constexpr double kMostApart = 0.02;

// Roundings of the input that may explain a difference, in units of 2^-24 of the largest coordinate involved: a kernel
// takes some dozens of operations from its input to a decision.
inline constexpr double kNudge = 16;

} // namespace hyalite::parity
