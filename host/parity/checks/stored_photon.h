// Adds a photon stored by a kernel to an answer.
#pragma once

#include "parity/answer.h"
#include "reference/photons/photons.h"

#include <cstdint>

namespace hyalite::parity {

// `Fields` has kind, length, marked, position, direction, normal, power.
template <class Fields>
void addPhoton(Answer& answer, const Fields& fields, std::uint32_t kind, std::uint32_t length, bool marked,
               const reference::Photon& photon) {
    answer.exact(fields.kind, kind);
    answer.exact(fields.length, length);
    answer.exact(fields.marked, marked ? 1 : 0);
    answer.vector(fields.position, photon.position);
    answer.vector(fields.direction, photon.direction);
    answer.vector(fields.normal, photon.normal);
    answer.vector(fields.power, photon.power);
}

} // namespace hyalite::parity
