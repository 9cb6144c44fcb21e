// The list of shapes. To add a shape type, add a file next to this one and a row here. If no existing alternative of
// Shape (scene/model/scene.h) can represent it, add one, with bounds, a record, a kernel function and its reference.
#pragma once

#include "kinds/shapes/shape_kind.h"

#include <array>

namespace hyalite::kinds {

extern const ShapeKind kSphereShape;
extern const ShapeKind kBoxShape;
extern const ShapeKind kCylinderShape;
extern const ShapeKind kConeShape;
extern const ShapeKind kTorusShape;
extern const ShapeKind kEllipsoidShape;
extern const ShapeKind kParaboloidShape;
extern const ShapeKind kHyperboloidOneSheetShape;
extern const ShapeKind kHyperboloidTwoSheetsShape;
extern const ShapeKind kHyperbolicParaboloidShape;
extern const ShapeKind kQuadricShape;
extern const ShapeKind kPlaneShape;
extern const ShapeKind kQuadShape;
extern const ShapeKind kDiskShape;
extern const ShapeKind kMeshShape;
extern const ShapeKind kTeapotShape;
extern const ShapeKind kCsgShape;

inline constexpr std::array kShapeKinds{
    &kSphereShape,
    &kBoxShape,
    &kCylinderShape,
    &kConeShape,
    &kTorusShape,
    &kEllipsoidShape,
    &kParaboloidShape,
    &kHyperboloidOneSheetShape,
    &kHyperboloidTwoSheetsShape,
    &kHyperbolicParaboloidShape,
    &kQuadricShape,
    &kPlaneShape,
    &kQuadShape,
    &kDiskShape,
    &kMeshShape,
    &kTeapotShape,
    &kCsgShape,
};

} // namespace hyalite::kinds
