// Second-degree surfaces within a box: ellipsoids, cones, cylinders, paraboloids, hyperboloids, boxes, half-spaces.
#ifndef HYALITE_QUADRIC_GLSL
#define HYALITE_QUADRIC_GLSL
#include "shapes/local_ray.glsl"

// q(p) = p.(A p) + 2 linear.p + constant with A symmetric.
struct QuadricForm {
    vec3 diagonal;    // a, e, h
    vec3 offDiagonal; // b, c, f
    vec3 linear;      // d, g, i
    float constant;   // j
    vec3 low;         // the box
    vec3 high;
};

QuadricForm quadricForm(uint object) {
    vec4 diagonal = objectTexel(object, 4u);
    vec4 offDiagonal = objectTexel(object, 5u);
    vec4 linear = objectTexel(object, 6u);
    vec4 sides = objectTexel(object, 7u);
    return QuadricForm(diagonal.xyz, offDiagonal.xyz, linear.xyz, diagonal.w, vec3(offDiagonal.w, sides.xz),
                       vec3(linear.w, sides.yw));
}

// A v; with absolute values of all arguments, a bound on the summed terms.
vec3 timesSymmetric(vec3 diagonal, vec3 offDiagonal, vec3 v) {
    return diagonal * v + offDiagonal.xxy * v.yxx + offDiagonal.yzz * v.zzy;
}

// The part of the line p + t d within a box, and the faces by which it enters and leaves.
struct BoxSpan {
    vec2 t;
    uvec2 part;
};

BoxSpan boxSpan(vec3 p, vec3 d, vec3 low, vec3 high) {
    vec3 inverse = 1.0 / awayFromZero(d);
    vec3 tLow = (low - p) * inverse;
    vec3 tHigh = (high - p) * inverse;
    vec3 enter = lesser(tLow, tHigh);
    vec3 leave = greater(tLow, tHigh);
    uvec3 backward = uvec3(lessThan(inverse, vec3(0.0)));
    uint enterAxis = enter.x >= enter.y ? (enter.x >= enter.z ? 0u : 2u) : (enter.y >= enter.z ? 1u : 2u);
    uint leaveAxis = leave.x <= leave.y ? (leave.x <= leave.z ? 0u : 2u) : (leave.y <= leave.z ? 1u : 2u);
    return BoxSpan(vec2(enter[enterAxis], leave[leaveAxis]),
                   uvec2(1u + 2u * enterAxis + backward[enterAxis], 2u + 2u * leaveAxis - backward[leaveAxis]));
}

// The parameters between which (`between`) or outside of which q(p + t d) <= 0; equal if q does not change sign.
struct FormRoots {
    vec2 t;
    bool between;
};

// One step of Newton's method: where the form changes fast, the roots of its restriction to the line are less accurate
// than the form itself. Near a double root they are as accurate, and the step is skipped.
float polishedRoot(QuadricForm form, vec3 p, vec3 d, float t, float apart) {
    vec3 x = p + t * d;
    vec3 halfGradient = timesSymmetric(form.diagonal, form.offDiagonal, x) + form.linear;
    float q = dot(x, halfGradient + form.linear) + form.constant;
    float polished = t - q / (2.0 * dot(halfGradient, d));
    return abs(polished - t) < 0.0625 * apart ? polished : t;
}

FormRoots formRoots(QuadricForm form, vec3 p, vec3 d) {
    vec3 Ad = timesSymmetric(form.diagonal, form.offDiagonal, d);
    float A = dot(d, Ad);
    float B = dot(p, Ad) + dot(form.linear, d);
    // Moved to the minimum of q along the line (already there for a sphere), so that no large terms of B^2 - A C cancel
    float toVertex = A == 0.0 ? 0.0 : -B / A;
    vec3 vertex = p + toVertex * d;
    if (dot(vertex, vertex) <= 16.0 * dot(p, p)) {
        p = vertex;
        B = dot(p, Ad) + dot(form.linear, d);
    } else {
        toVertex = 0.0;
    }
    vec3 Ap = timesSymmetric(form.diagonal, form.offDiagonal, p);
    float C = dot(p, Ap + 2.0 * form.linear) + form.constant;
    float discriminant = B * B - A * C;
    if (discriminant < 0.0 || (A == 0.0 && B == 0.0)) {
        bool allInside = A < 0.0 || (A == 0.0 && C <= 0.0);
        return FormRoots(vec2(0.0), !allInside);
    }
    // Neither root is a difference of nearly equal numbers [Haines19]; A = 0 sends one of them to infinity, on the side
    // that makes the interval a half-line
    float root = sqrt(discriminant);
    float q = B > 0.0 ? -B - root : root - B;
    float other = q == 0.0 ? 0.0 : C / q;
    float first = A == 0.0 ? (q < 0.0 ? -kInfinity : kInfinity) : lesser(greater(q / A, -kInfinity), kInfinity);
    vec2 roots = vec2(lesser(first, other), greater(first, other));
    roots = vec2(polishedRoot(form, p, d, roots.x, roots.y - roots.x), polishedRoot(form, p, d, roots.y, roots.y - roots.x));
    return FormRoots(roots + toVertex, A >= 0.0);
}

// Appends [from, to] if it is not empty.
void appendSpan(inout Crossings crossings, vec2 t, uvec2 part) {
    if (t.x < t.y) {
        if (crossings.t.x == kInfinity) {
            crossings.t.xy = t;
            crossings.part.xy = part;
        } else {
            crossings.t.zw = t;
            crossings.part.zw = part;
        }
    }
}

Crossings quadricCrossings(uint object, uint type, vec3 o, vec3 d) {
    QuadricForm form = quadricForm(object);
    LocalRay ray = localRay(object, o, d);
    BoxSpan box = boxSpan(ray.p, ray.d, form.low, form.high);
    Crossings crossings = noCrossings();
    if (!(box.t.x < box.t.y)) {
        return crossings;
    }
    FormRoots roots = formRoots(form, ray.p, ray.d);
    if ((type & kShapeOpen) != 0u) {
        // An open surface, not a solid: its roots within the box
        bool crosses = roots.t.x < roots.t.y;
        crossings.t.x = crosses && roots.t.x >= box.t.x && roots.t.x <= box.t.y ? roots.t.x : kInfinity;
        crossings.t.y = crosses && roots.t.y >= box.t.x && roots.t.y <= box.t.y ? roots.t.y : kInfinity;
    } else if (roots.between) {
        bvec2 byBox = bvec2(box.t.x > roots.t.x, box.t.y < roots.t.y);
        appendSpan(crossings, mix(roots.t, box.t, byBox), mix(uvec2(kPartForm), box.part, byBox));
    } else if (roots.t.x < roots.t.y) {
        bvec2 byBox = bvec2(box.t.y < roots.t.x, box.t.x > roots.t.y);
        vec2 inner = mix(roots.t, box.t.yx, byBox);
        uvec2 part = mix(uvec2(kPartForm), box.part.yx, byBox);
        appendSpan(crossings, vec2(box.t.x, inner.x), uvec2(box.part.x, part.x));
        appendSpan(crossings, vec2(inner.y, box.t.y), uvec2(part.y, box.part.y));
    } else {
        appendSpan(crossings, box.t, box.part);
    }
    // An unbounded end is not a crossing
    crossings.t = mix(crossings.t + ray.start, crossings.t, greaterThan(abs(crossings.t), vec4(kEndless)));
    crossings.t = mix(crossings.t, vec4(kInfinity), greaterThan(crossings.t, vec4(kEndless)));
    return crossings;
}
#endif
