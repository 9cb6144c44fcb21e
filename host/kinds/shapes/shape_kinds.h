// The list of shapes. A new type of shape is a file beside this one and a row here; one that is no case of a Shape that
// there is needs one there too (scene/model/scene.h), with bounds, a record, a kernel's function and the reference's.
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
