// The diffuse part of a surface. What photons and lights bring there is multiplied by a value that stands in
// VisiblePoint.f, and by a factor of its own direction alone: so a coat over the surface lets light in by one factor and
// out by another.
#ifndef HYALITE_DIFFUSE_GLSL
#define HYALITE_DIFFUSE_GLSL

// (1 - cosine)^5, for Schlick's approximation.
float schlickPower(float cosine) {
    float c = clamp(1.0 - cosine, 0.0, 1.0);
    return c * c * c * c * c;
}

// What a coat (1; 0: none) lets through at the angle [Shirley97a]. With F0 at normal incidence Schlick's approximation
// reflects 1 - (1 - F0) times this.
float diffuseFactor(float coat, float cosine) {
    return 1.0 - coat * schlickPower(cosine);
}

// Makes up for the mean of the factor over the cosine-weighted hemisphere, 20/21.
const float kCoatNormalization = 21.0 / 20.0;

// That mean, for light that comes evenly from everywhere: the integral of 2 c (1 - c)^5 over c in [0, 1] is 1/21.
float meanDiffuseFactor(float coat) {
    return 1.0 - coat / 21.0;
}
#endif
