// Formulas of optics for the tables, from textbooks; nothing here is shared with the renderers.
#pragma once

#include <vector>

namespace hyalite::testing {

// Fresnel reflectance for unpolarised light at a face from index n1 to n2, with the ray in n1 at this cosine to the
// normal; 1 beyond the critical angle.
[[nodiscard]] double fresnel(double cosine, double n1, double n2);

// The same from air to the complex index eta + i k.
[[nodiscard]] double metalFresnel(double cosine, double eta, double k);

struct Slab {
    double index = 1.5;
    double thickness = 0; // [m]
    double sigma = 0;     // absorption [1/m]
};
struct Stack {
    double reflectance = 0;
    double transmittance = 0;
};

// Slabs one behind the other, air between and around them, met at this angle to their normals [rad]: faces and layers
// are added one by one, intensities without interference, as in the adding method [Stokes1862].
[[nodiscard]] Stack addSlabs(const std::vector<Slab>& slabs, double angle);

// Layers that touch: one medium after the other, air around them.
[[nodiscard]] Stack addTouching(const std::vector<Slab>& layers, double angle);

} // namespace hyalite::testing
