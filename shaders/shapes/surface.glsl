// The surface at a hit, as paths need it.
#ifndef HYALITE_SURFACE_GLSL
#define HYALITE_SURFACE_GLSL
#include "shared/limits.h"
#include "shared/path_records.h"
#include "shapes/solids.glsl"
#include "lib/specialization.glsl"

struct Surface {
    vec3 position;        // world [m]
    vec3 geometricNormal; // unit, on the side the ray came from
    vec3 normal;          // likewise, interpolated if the mesh has normals
    float error;          // bound on the error of position [m]
    bool front;           // the ray came from outside; on flat shapes, from the side the normal is on
    uint object;          // for CSG the solid, not the leaf
    uint material;
    uint light;
    vec2 uv;     // for textures: set if the scene has any
    uint beyond; // media on the other side, see media.h; set by whoever knows those on this side
};

// Error of positions: on quads and spheres, the position and the next ray's intersection with the surface take a
// handful of roundings, each at most 2^-24 of the largest term; on transformed triangles about twice as many. Twice
// that is safe, and small enough that hits do not move visibly.
const float kPositionError = 4.76837158203125e-7; // 2^-21
const float kTransformedPositionError = 1.9073486328125e-6; // 2^-19

// Distance of a point of a quad from its plane: only the roundings of n.p, here and when the next ray meets the plane.
// That is three each time, one where p is moved onto the plane and one where the ray moves off it, each at most 2^-24
// of the sum of |n_i p_i|; ten are assumed.
const float kPlaneError = 5.9604644775390625e-7; // 10 * 2^-24

// Points of quadrics and tori: the map to their space, evaluating the form, the map back, and the same again for the
// next ray.
const float kFormError = 9.5367431640625e-7; // 2^-20
const float kLargestError = 0.0009765625;    // 2^-10 of the distance to the centre

float largestCoordinate(vec3 p) {
    return maxComponent(abs(p));
}

vec3 toWorld(InstanceRecord instance, vec4 p) {
    return vec3(dot(instance.row0, p), dot(instance.row1, p), dot(instance.row2, p));
}

// A hit from farther than this, in radii of curvature, is found again near the shape, because the rounding of t
// would put it beside the surface and turn the normal. Up to there one step of Newton's method suffices.
const float kFarHit = 1024.0;

// Is the hit at `t` the first of these roots, measured from `start` on? The one where the ray enters if rounding of t
// hides which.
bool isFirstRoot(vec2 roots, bool firstEnters, float t, float start) {
    float s = t - start;
    return roots.y - roots.x > kPositionError * t ? abs(roots.x - s) <= abs(roots.y - s) : firstEnters;
}

// The point of the sphere that a ray hits from afar, relative to the centre.
vec3 farOnSphere(vec4 sphere, Ray ray, float t) {
    float start = dot(sphere.xyz - ray.origin, ray.direction);
    vec3 nearest = alongRay(ray.origin, sphere.xyz, ray.direction, start);
    nearest -= (dot(nearest, ray.direction) / dot(ray.direction, ray.direction)) * ray.direction; // `start` is rounded
    float reach = sqrt(greater(sphere.w * sphere.w - dot(nearest, nearest), 0.0));
    return nearest + (isFirstRoot(vec2(-reach, reach), true, t, start) ? -reach : reach) * ray.direction;
}

// Projects the point back onto the sphere: then it is accurate to the rounding of its coordinates, however long the
// ray.
vec3 placeOnSphere(uint object, Ray ray, float t, vec3 p, inout Surface s) {
    vec4 sphere = objectTexel(object, 0u);
    vec3 outward = normalize(t > kFarHit * sphere.w ? farOnSphere(sphere, ray, t) : p - sphere.xyz);
    s.position = sphere.xyz + sphere.w * outward;
    s.error = kPositionError * (largestCoordinate(sphere.xyz) + sphere.w);
    return outward;
}

// The point, relative to the centre, where a ray from afar hits the plane normal . p = offset: moved along the ray by the
// rounding of t, which a projection along the normal would leave as a shift within the plane.
vec3 farOnPlane(vec3 normal, float offset, vec3 center, Ray ray, float t) {
    vec3 p = alongRay(ray.origin, center, ray.direction, t);
    float slope = dot(normal, ray.direction);
    float most = kPositionError * t;
    return p + clamp((offset - dot(normal, p)) / (slope == 0.0 ? kTiny : slope), -most, most) * ray.direction;
}

vec3 placeOnPlane(uint object, Ray ray, float t, vec3 p, inout Surface s) {
    vec4 plane = objectTexel(object, 0u);
    if (t > kFarHit * largestCoordinate(p)) {
        p = farOnPlane(plane.xyz, plane.w, vec3(0.0), ray, t);
    }
    s.position = p + (plane.w - dot(plane.xyz, p)) * plane.xyz;
    s.error = kPlaneError * dot(abs(plane.xyz), abs(p));
    return plane.xyz;
}

// A face of a quadric's box, in the form's space.
vec3 placeOnFace(QuadricForm form, uint part, vec4 rows[3], vec3 center, Ray ray, float t, vec3 p, inout Surface s) {
    uint axis = (part - 1u) >> 1u;
    bool high = ((part - 1u) & 1u) != 0u;
    vec4 row = rows[axis];
    float side = high ? form.high[axis] : form.low[axis];
    float scale = dot(row.xyz, row.xyz);
    vec3 fromCenter = p - center;
    if (t > kFarHit * largestCoordinate(fromCenter)) {
        fromCenter = farOnPlane(row.xyz, side, center, ray, t);
        p = center + fromCenter;
    }
    s.position = p + ((side - dot(row.xyz, fromCenter)) / scale) * row.xyz;
    s.error = 2.0 * kPlaneError * (dot(abs(row.xyz), abs(p) + abs(center)) + abs(side)) / sqrt(scale);
    return row.xyz * ((high ? 1.0 : -1.0) / sqrt(scale));
}

// Bound on the distance from the surface of a point where the form is at most `value` (rounding included) and its slope
// is `slope` [1/m]; limited to `most` where the slope vanishes, at the apex of a cone.
float errorOver(float value, float slope, float most) {
    return value < slope * most ? value / slope : most;
}

// The point of the form's surface that a ray hits from afar, relative to the centre [world].
vec3 farOnForm(uint object, QuadricForm form, vec3 center, Ray ray, float t) {
    LocalRay line = localRay(object, ray.origin, ray.direction);
    FormRoots roots = formRoots(form, line.p, line.d);
    float s = isFirstRoot(roots.t, roots.between, t, line.start) ? roots.t.x : roots.t.y;
    return alongRay(ray.origin, center, ray.direction, line.start) + s * ray.direction;
}

// One step of Newton's method along the gradient moves the point onto the surface, up to the rounding of q: a few times
// 2^-24 of the sum of its terms.
vec3 placeOnQuadric(uint object, Ray ray, float t, uint part, vec3 p, inout Surface s) {
    vec4 rows[3] = vec4[3](objectTexel(object, 0u), objectTexel(object, 1u), objectTexel(object, 2u));
    vec3 center = vec3(rows[0].w, rows[1].w, rows[2].w);
    QuadricForm form = quadricForm(object);
    if (part != kPartForm) {
        return placeOnFace(form, part, rows, center, ray, t, p, s);
    }
    vec3 fromCenter = p - center;
    vec3 local = toLocal(rows[0], rows[1], rows[2], fromCenter);
    vec3 halfGradient = timesSymmetric(form.diagonal, form.offDiagonal, local) + form.linear;
    // The radius of curvature is at least the half gradient over the largest coefficient
    float curvature = maxComponent(greater(abs(form.diagonal), abs(form.offDiagonal)));
    if (t * length(toLocal(rows[0], rows[1], rows[2], ray.direction)) * curvature > kFarHit * length(halfGradient)) {
        fromCenter = farOnForm(object, form, center, ray, t);
        p = center + fromCenter;
        local = toLocal(rows[0], rows[1], rows[2], fromCenter);
        halfGradient = timesSymmetric(form.diagonal, form.offDiagonal, local) + form.linear;
    }
    float q = dot(local, halfGradient + form.linear) + form.constant;
    vec3 gradient = 2.0 * (halfGradient.x * rows[0].xyz + halfGradient.y * rows[1].xyz + halfGradient.z * rows[2].xyz);
    float slope = length(gradient);

    vec3 localTerms = vec3(dot(abs(rows[0].xyz), abs(fromCenter)), dot(abs(rows[1].xyz), abs(fromCenter)),
                           dot(abs(rows[2].xyz), abs(fromCenter)));
    vec3 gradientTerms = timesSymmetric(abs(form.diagonal), abs(form.offDiagonal), localTerms) + abs(form.linear);
    float terms = dot(localTerms, gradientTerms + abs(form.linear)) + abs(form.constant);
    float size = largestCoordinate(fromCenter);
    float most = kLargestError * size;
    s.error = kFormError * largestCoordinate(max(abs(p), abs(center))) + errorOver(kFormError * terms, slope, most);
    s.position = p - (sign(q) * errorOver(abs(q), slope, most) / max(slope, kTiny)) * gradient;
    return slope > 0.0 ? gradient / slope : -ray.direction;
}

// The point of a torus that a ray hits from afar, relative to the centre [world]: Newton's method from the hit, of which
// no step is longer than the rounding of t.
vec3 farOnTorus(uint object, vec2 radii, vec3 center, Ray ray, float t) {
    LocalRay local = localRay(object, ray.origin, ray.direction);
    float speed = length(local.d) / radii.x;
    TorusLine line = TorusLine(local.p / radii.x, normalize(local.d), radii.y / radii.x);
    float u = (t - local.start) * speed;
    float most = kPositionError * t * speed;
    for (int i = 0; i < 8; ++i) {
        vec2 distance = torusDistance(line, u);
        u -= clamp(distance.x / (distance.y == 0.0 ? kTiny : distance.y), -most, most);
    }
    return alongRay(ray.origin, center, ray.direction, local.start) + (u / speed) * ray.direction;
}

vec3 placeOnTorus(uint object, Ray ray, float t, vec3 p, inout Surface s) {
    vec4 rows[3] = vec4[3](objectTexel(object, 0u), objectTexel(object, 1u), objectTexel(object, 2u));
    vec2 radii = objectTexel(object, 4u).xy;
    vec3 center = vec3(rows[0].w, rows[1].w, rows[2].w);
    vec3 fromCenter = p - center;
    if (t * length(toLocal(rows[0], rows[1], rows[2], ray.direction)) > kFarHit * radii.y) {
        fromCenter = farOnTorus(object, radii, center, ray, t);
        p = center + fromCenter;
    }
    vec3 local = toLocal(rows[0], rows[1], rows[2], fromCenter);
    float fromAxis = length(local.xz);
    vec2 fromRing = vec2(fromAxis - radii.x, local.y);
    float distance = length(fromRing);
    vec2 slope2 = fromRing / distance;
    vec2 axial = slope2.x * local.xz / fromAxis;
    vec3 gradient = axial.x * rows[0].xyz + slope2.y * rows[1].xyz + axial.y * rows[2].xyz;
    float slope = length(gradient);
    s.position = p - ((distance - radii.y) / (slope * slope)) * gradient;
    s.error = kFormError * (largestCoordinate(max(abs(p), abs(center))) + (radii.x + radii.y) / slope);
    return gradient / slope;
}

// Also sets the normal, interpolated if the mesh has normals.
vec3 placeOnTriangle(Hit hit, bool smoothed, NormalArray normals, InstanceArray instances, inout Surface s) {
    GeometryRecord triangle = geometryRecord(hit.primitive);
    vec3 a = uintBitsToFloat(triangle.a.xyz);
    vec3 b = uintBitsToFloat(triangle.b.xyz);
    vec3 c = uintBitsToFloat(triangle.c.xyz);
    vec3 weights = vec3(1.0 - hit.uv.x - hit.uv.y, hit.uv);
    vec3 p = weights.x * a + weights.y * b + weights.z * c;
    InstanceRecord instance = instances.at[hit.object];
    s.position = toWorld(instance, vec4(p, 1.0));
    vec3 terms = abs(instance.row0.xyz) * abs(p.x) + abs(instance.row1.xyz) * abs(p.y)
               + abs(instance.row2.xyz) * abs(p.z)
               + abs(vec3(instance.row0.w, instance.row1.w, instance.row2.w));
    s.error = kTransformedPositionError * largestCoordinate(max(terms, abs(s.position)));
    // Normals transform by the inverse transpose: the rows of world-to-object, which the object table holds
    mat3 rows = mat3(objectTexel(hit.object, 0u).xyz, objectTexel(hit.object, 1u).xyz, objectTexel(hit.object, 2u).xyz);
    vec3 outward = normalize(rows * cross(b - a, c - a));
    s.normal = outward;
    if (!smoothed) {
        return outward;
    }
    vec3 smoothNormal = weights.x * normals.at[3u * hit.primitive] + weights.y * normals.at[3u * hit.primitive + 1u]
                      + weights.z * normals.at[3u * hit.primitive + 2u];
    s.normal = dot(smoothNormal, smoothNormal) > 0.0 ? normalize(rows * smoothNormal) : outward;
    return outward;
}

// Texture coordinates. Spheres: longitude from -z by way of -x and latitude from -y to +y, in world directions; disks:
// their bounding square. Shapes without coordinates have (0, 0).
vec2 textureCoordinates(uint type, Hit hit, vec3 outward) {
    if (isShape(type, kShapeMesh)) {
        vec4 first = texelFetch(coordinateTable, int(kTexelsPerCoordinates * hit.primitive));
        vec2 third = texelFetch(coordinateTable, int(kTexelsPerCoordinates * hit.primitive + 1u)).xy;
        return (1.0 - hit.uv.x - hit.uv.y) * first.xy + hit.uv.x * first.zw + hit.uv.y * third;
    }
    if (isShape(type, kShapeSphere)) {
        float level = sqrt(outward.x * outward.x + outward.z * outward.z);
        return vec2(0.5 + angleInTurns(outward.x, outward.z), 0.5 + 2.0 * angleInTurns(outward.y, level));
    }
    if (isShape(type, kShapeDisk)) {
        return 0.5 * hit.uv + 0.5;
    }
    return isShape(type, kShapeQuad) ? hit.uv : vec2(0.0);
}

// Beyond this multiple of the hit's largest coordinate, the rounding of t is more than the length of a place.
const float kFarFromLeaf = 32.0;

Surface surfaceAt(Ray ray, Hit hit, NormalArray normals, InstanceArray instances) {
    ObjectHeader header = objectHeader(hit.object);
    Surface s;
    bool isLeaf = sceneHas(kShapeCsg) && (header.type & kShapeLeaf) != 0u;
    s.object = isLeaf ? header.light : hit.object;
    s.material = header.material;
    s.light = isLeaf ? kNone : header.light;
    vec3 p = ray.origin + hit.t * ray.direction;
    bool enters = isLeaf && (hit.primitive & kHitEnters) != 0u;
    hit.primitive &= ~kHitEnters;
    vec3 outward;
    if (isShape(header.type, kShapeMesh)) {
        outward = placeOnTriangle(hit, (header.type & kShapeSmooth) != 0u, normals, instances, s);
    } else {
        if (isShape(header.type, kShapeSphere)) {
            outward = placeOnSphere(hit.object, ray, hit.t, p, s);
        } else if (isShape(header.type, kShapeQuadric)) {
            outward = placeOnQuadric(hit.object, ray, hit.t, hit.primitive, p, s);
        } else if (isShape(header.type, kShapeTorus)) {
            outward = placeOnTorus(hit.object, ray, hit.t, p, s);
        } else {
            outward = placeOnPlane(hit.object, ray, hit.t, p, s);
        }
        s.normal = outward;
    }
    s.beyond = kNoMedia;
    s.uv = kTextures != 0u ? textureCoordinates(header.type, hit, outward) : vec2(0.0);
    if (isLeaf) {
        // The hit on the solid, not on this leaf: at an edge the two differ by a place (see csg.glsl). From afar, where p
        // is off by more than a place, the leaf. No error: a ray that leaves a solid knows on which side it starts
        if (!(hit.t > kFarFromLeaf * largestCoordinate(p))) {
            s.position = p;
        } else if (isShape(header.type, kShapeSphere) && isNearOrigin(objectTexel(hit.object, 0u), p)) {
            vec4 sphere = objectTexel(hit.object, 0u);
            s.position = p - (sphereForm(hit.object, sphere, p) / (2.0 * sphere.w)) * outward;
        }
        s.error = 0.0;
    }
    if (isLeaf && (header.type & kShapeReversed) != 0u) {
        outward = -outward;
        s.normal = -s.normal;
    }
    s.front = isLeaf ? enters : dot(ray.direction, outward) < 0.0; // for CSG the walk knows, even at grazing incidence
    s.geometricNormal = s.front ? outward : -outward;
    s.normal = s.front ? s.normal : -s.normal;
    return s;
}

// The `from` of a ray that leaves the surface (see Ray); `through`: to the side opposite the arriving ray.
uint leaving(Surface s, bool through) {
    return (1u + s.object) | (s.front == through ? kRayInside : 0u);
}

// A ray from the surface in `direction`, offset by the position's error to the side it goes to.
Ray leaveSurface(Surface s, vec3 direction, bool through) {
    float side = dot(direction, s.geometricNormal) < 0.0 ? -1.0 : 1.0;
    return Ray(s.position + (side * s.error) * s.geometricNormal, kInfinity, direction, leaving(s, through));
}
#endif
