// Marble: dark veins where a coordinate, bent by four octaves of noise, passes a half. parameters: scale [1/m], how far the
// noise bends [veins], sharpness. Its twin in double precision: marble.twin.cpp.
float marbleCorner(vec3 corner) {
    uint bits = hashCombine(hashCombine(hash(uint(int(corner.x))), uint(int(corner.y))), uint(int(corner.z)));
    return float(bits >> 8u) * 5.9604644775390625e-8; // 2^-24
}

float marbleNoise(vec3 p) {
    vec3 corner = floor(p);
    vec3 f = p - corner;
    vec3 w = f * f * (3.0 - 2.0 * f);
    float sum = 0.0;
    for (int i = 0; i < 8; ++i) {
        vec3 s = vec3(i & 1, (i >> 1) & 1, i >> 2);
        vec3 share = mix(1.0 - w, w, s);
        sum += share.x * share.y * share.z * marbleCorner(corner + s);
    }
    return sum;
}

vec3 marble(vec3 position, vec2 uv, vec4 parameters) {
    vec3 p = position * parameters.x;
    float turbulence = 0.0;
    float scale = 1.0;
    for (int octave = 0; octave < 4; ++octave) {
        turbulence += (marbleNoise(p * scale) - 0.5) / scale;
        scale *= 2.0;
    }
    float along = p.x + p.y + parameters.y * turbulence;
    float distance = abs(along - floor(along) - 0.5);
    float vein = max(0.0, 1.0 - distance * parameters.z);
    return mix(vec3(0.85, 0.83, 0.8), vec3(0.12, 0.13, 0.18), vein * vein);
}
