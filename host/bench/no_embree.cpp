// Replaces embree_tracer.cpp if Embree is not installed.
#include "bench/embree_tracer.h"

namespace hyalite::bench {

std::string embreeVersion() {
    return {};
}

std::unique_ptr<RayTracer> makeEmbreeTracer(const Scene& /*scene*/) {
    return nullptr;
}

} // namespace hyalite::bench
