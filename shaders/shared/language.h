// Lets the C++ compiler and glslang read the same header: the same vector names on both sides, one way to declare an
// array in device memory, and integer functions written once.
#ifndef HYALITE_SHARED_LANGUAGE_H
#define HYALITE_SHARED_LANGUAGE_H

#ifdef __cplusplus

#include <cstdint>
#include <glm/glm.hpp>

namespace hyalite::shared {
using uint = std::uint32_t;
using glm::ivec3;
using glm::uvec2;
using glm::uvec3;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
} // namespace hyalite::shared

#define SHARED_BEGIN namespace hyalite::shared {
#define SHARED_END }
#define SHARED_FUNCTION [[nodiscard]] inline
#define SHARED_CONSTANT inline constexpr uint
#define SHARED_FLOAT inline constexpr float
// On the host a device array is its address.
#define DEVICE_ARRAY(Type, Name)                                                                                       \
    struct Name {                                                                                                      \
        std::uint64_t address = 0;                                                                                     \
    }

#else

#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_scalar_block_layout : require

#define SHARED_BEGIN
#define SHARED_END
#define SHARED_FUNCTION
#define SHARED_CONSTANT const uint
#define SHARED_FLOAT const float
#ifdef HYALITE_CHECKED
#include "lib/checked.glsl"
// Declared with one element: an offset added to an array is counted in elements and so addresses the right one.
#define DEVICE_ARRAY(Type, Name)                                                                                       \
    layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Name {                                         \
        Type at[1];                                                                                                    \
    }
#else
#define DEVICE_ARRAY(Type, Name)                                                                                       \
    layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Name {                                         \
        Type at[];                                                                                                     \
    }
#endif

#endif
SHARED_BEGIN
// The only array of words: of two array types with the same elements, spirv-opt takes pointers in a record for the
// other.
DEVICE_ARRAY(uint, UintArray);
SHARED_END
#endif
