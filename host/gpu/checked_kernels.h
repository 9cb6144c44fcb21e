// The checked build of the kernels (preset `checked`): every index into an array of device memory, a private array or a
// table is bounds-checked (shaders/lib/checked.glsl). An index out of bounds is reported with its kernel, source line
// and thread, and accesses element 0 instead.
#pragma once

#include <cstdint>
#include <string>

namespace hyalite::gpu {

#ifdef HYALITE_CHECKED_KERNELS
inline constexpr bool kCheckedKernels = true;
#else
inline constexpr bool kCheckedKernels = false;
#endif

// The binding, beyond all tables, from which kernels read the size of every buffer.
inline constexpr std::uint32_t kCheckBinding = 31;

// A shader's text with its accesses rewritten: `x.at[i]` to `(x + checkedIndex(x, x + 1, i, site)).at [0]`, `a[i]` of
// an array that the text declares to `a[checkedEntry(i, a.length(), site)]`, `texelFetch(t, i)` to `texelFetch(t,
// checkedTexel(t, i, site))`. A site is the line number, with `file` above kSiteLineBits.
inline constexpr std::uint32_t kSiteLineBits = 16;
[[nodiscard]] std::string withBoundChecks(const std::string& text, std::uint32_t file);

} // namespace hyalite::gpu
