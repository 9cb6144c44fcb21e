// The torus (sqrt(x^2 + z^2) - major)^2 + y^2 = minor^2: a quartic, solved by the cascade of its derivatives
// [Yuksel22]. Between two roots of the derivative there is at most one root. The polynomial only brackets it; the root
// itself is refined on the distance to the torus, which single precision evaluates accurately.
#ifndef HYALITE_TORUS_GLSL
#define HYALITE_TORUS_GLSL
#include "shapes/local_ray.glsl"

// A line p + u d relative to a torus of major radius 1; p.d = 0, d unit.
struct TorusLine {
    vec3 p;
    vec3 d;
    float minor;
};

// Distance to the torus at p + u d, and its derivative by u.
vec2 torusDistance(TorusLine line, float u) {
    vec3 p = line.p + u * line.d;
    float fromAxis = length(p.xz);
    vec2 fromRing = vec2(fromAxis - 1.0, p.y);
    float distance = length(fromRing);
    float outward = fromAxis > 0.0 ? dot(p.xz, line.d.xz) / fromAxis : 0.0;
    float slope = distance > 0.0 ? dot(fromRing, vec2(outward, line.d.y)) / distance : 0.0;
    return vec2(distance - line.minor, slope);
}

const int kPolishSteps = 32; // enough for bisection alone; Newton's method takes about five

// The root of 4 u^3 + 2 c2 u + c1, monotone between low and high, if the signs there differ; else the end with the
// smaller value, which serves as well: there are no roots of the quartic to separate.
float cubicRoot(float c2, float c1, float low, float high) {
    float atLow = (4.0 * low * low + 2.0 * c2) * low + c1;
    float atHigh = (4.0 * high * high + 2.0 * c2) * high + c1;
    if ((atLow > 0.0) == (atHigh > 0.0)) {
        return abs(atLow) < abs(atHigh) ? low : high;
    }
    float u = 0.5 * (low + high);
    for (int i = 0; i < kPolishSteps; ++i) {
        float value = (4.0 * u * u + 2.0 * c2) * u + c1;
        low = (value > 0.0) == (atLow > 0.0) ? u : low;
        high = (value > 0.0) == (atLow > 0.0) ? high : u;
        float next = u - value / (12.0 * u * u + 2.0 * c2);
        next = next > low && next < high ? next : 0.5 * (low + high);
        if (abs(next - u) < 1.0e-6) {
            break; // accurate enough: it only brackets a root
        }
        u = next;
    }
    return u;
}

// The zero of the distance, which is nearly monotone between low and high and has opposite signs there.
float torusRoot(TorusLine line, float low, float high, bool entering) {
    float u = 0.5 * (low + high);
    for (int i = 0; i < kPolishSteps; ++i) {
        vec2 distance = torusDistance(line, u);
        bool before = (distance.x > 0.0) == entering;
        low = before ? u : low;
        high = before ? high : u;
        float next = u - distance.x / distance.y;
        next = next >= low && next <= high ? next : 0.5 * (low + high);
        if (abs(next - u) < 6.0e-8) {
            return next;
        }
        u = next;
    }
    return u;
}

Crossings torusCrossings(uint object, vec3 o, vec3 d) {
    Crossings crossings = noCrossings();
    LocalRay ray = localRay(object, o, d);
    vec2 radii = objectTexel(object, 4u).xy;
    // Lengths in units of the major radius, along the line from its point nearest to the centre
    float speed = length(ray.d) / radii.x;
    TorusLine line = TorusLine(ray.p / radii.x, normalize(ray.d), radii.y / radii.x);
    float shift = -dot(line.p, line.d);
    line.p += shift * line.d;
    float reach = 1.0 + line.minor;
    float p2 = dot(line.p, line.p);
    float halfChord2 = reach * reach - p2;
    if (!(halfChord2 > 0.0)) {
        return crossings;
    }
    float end = sqrt(halfChord2);

    // (u^2 + k)^2 - 4 (x^2 + z^2) = u^4 + c2 u^2 + c1 u + c0 with k = p^2 + 1 - minor^2
    float k = p2 + (1.0 - line.minor) * (1.0 + line.minor);
    float c2 = 2.0 * k - 4.0 * dot(line.d.xz, line.d.xz);
    float c1 = -8.0 * dot(line.p.xz, line.d.xz);
    float flex = c2 < 0.0 ? min(sqrt(c2 / -6.0), end) : 0.0; // where the second derivative 12 u^2 + 2 c2 is zero
    float ends[5];
    ends[0] = -end;
    ends[1] = cubicRoot(c2, c1, -end, -flex);
    ends[2] = cubicRoot(c2, c1, -flex, flex);
    ends[3] = cubicRoot(c2, c1, flex, end);
    ends[4] = end;
    float scale = 1.0 / speed;
    float origin = ray.start + shift * scale;
    bool inside = false;
    int count = 0;
    for (int i = 1; i < 5; ++i) {
        bool insideNext = i < 4 && torusDistance(line, ends[i]).x < 0.0;
        if (insideNext != inside) {
            float t = origin + scale * torusRoot(line, ends[i - 1], ends[i], insideNext);
            // Two roots that rounding has merged count as none
            if (count > 0 && !(t > crossings.t[count - 1])) {
                crossings.t[--count] = kInfinity;
            } else {
                crossings.t[count++] = t;
            }
            inside = insideNext;
        }
    }
    return crossings;
}
#endif
