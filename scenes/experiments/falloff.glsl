// Photons count by (1 - u)^2: smooth at the rim, where the cone has a crease.
float falloff(float u) {
    return (1.0 - u) * (1.0 - u);
}
