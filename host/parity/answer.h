// The result of one thread of a kernel, or of its twin: a value for each field that the thread computes.
#pragma once

#include "parity/field.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace hyalite::parity {

class Answer {
public:
    struct Value {
        const Field* field = nullptr;
        std::uint64_t exact = 0;
        glm::dvec3 real{0}; // a number uses the first component
        double scale = 0;   // lower bound on what the error is relative to, in addition to the tolerance's own
    };

    void exact(const Field& field, std::uint64_t value) { values_.push_back({&field, value, glm::dvec3(0), 0}); }
    void number(const Field& field, double value, double scale = 0) {
        values_.push_back({&field, 0, glm::dvec3(value, 0, 0), scale});
    }
    void vector(const Field& field, const glm::dvec3& value, double scale = 0) {
        values_.push_back({&field, 0, value, scale});
    }

    [[nodiscard]] const std::vector<Value>& values() const { return values_; }
    [[nodiscard]] const Value* find(const Field& field) const; // nullptr: no such value

private:
    std::vector<Value> values_;
};

// Difference between the device's value and the twin's.
struct FieldError {
    double ulp = 0;      // in units in the last place of the scale as a float, the largest over the components
    double relative = 0; // over the scale
};
[[nodiscard]] FieldError errorOf(const Field& field, const Answer::Value& device, const Answer::Value& twin,
                                 double sceneScale);

} // namespace hyalite::parity
