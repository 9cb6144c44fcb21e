// What one thread of a kernel, or its twin, answered: a value for each field that has one.
#pragma once

#include "parity/tolerance.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <string_view>
#include <vector>

namespace hyalite::parity {

class Answer {
public:
    struct Value {
        std::string_view field;
        std::uint64_t exact = 0;
        glm::dvec3 real{0}; // of a number the first
        double scale = 0;   // that the error is relative to, at least; beside the tolerance's own
    };

    void exact(std::string_view field, std::uint64_t value) { values_.push_back({field, value, glm::dvec3(0), 0}); }
    void number(std::string_view field, double value, double scale = 0) {
        values_.push_back({field, 0, glm::dvec3(value, 0, 0), scale});
    }
    void vector(std::string_view field, const glm::dvec3& value, double scale = 0) {
        values_.push_back({field, 0, value, scale});
    }

    [[nodiscard]] const std::vector<Value>& values() const { return values_; }
    [[nodiscard]] const Value* find(std::string_view field) const;

private:
    std::vector<Value> values_;
};

// How far the device's value is from the twin's.
struct FieldError {
    double ulp = 0;      // in units in the last place of the scale as a float, the largest over the components
    double relative = 0; // over the scale
};
[[nodiscard]] FieldError errorOf(const Tolerance& tolerance, const Answer::Value& device, const Answer::Value& twin,
                                 double sceneScale);

} // namespace hyalite::parity
