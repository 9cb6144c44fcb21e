// The closest hit of a ray: for trace_closest, and for kernels that include it.
#pragma once

#include "parity/check.h"

#include "shaders/shared/path_records.h"

namespace hyalite::parity {

struct ClosestHitFields : FieldSet<5> {
    const Field& object = exact("object", kEdge);
    const Field& leaf = exact("leaf", kEdge);
    const Field& primitive = exact("primitive", kEdge);
    const Field& t = number("t", kPosition, Scale::Scene);
    const Field& place = FieldSet::place("place");
};
inline constexpr ClosestHitFields kClosestHit;

void compareClosestHit(const Stage& stage, std::size_t i, const shared::Ray& ray, const shared::Hit& hit);

} // namespace hyalite::parity
