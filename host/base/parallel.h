// Runs independent pieces of work on all cores; results must not depend on which thread does which piece.
#pragma once

#include <cstddef>
#include <functional>

namespace hyalite {

// Calls body(begin, end) for consecutive ranges that cover [0, count), each at most `grain` long (grain >= 1), from
// all cores at once. Returns when all are done; the first exception thrown by a body is rethrown here.
void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body);

} // namespace hyalite
