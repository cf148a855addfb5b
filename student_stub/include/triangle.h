#pragma once

#include "point3d.h"

/// A face: which three vertices of the mesh are its corners.
struct TriangleIndices {
    uint32_t v1;
    uint32_t v2;
    uint32_t v3;
};

/// A face with its corners looked up, written `Triangle{a, b, c}`.
///
/// The corners are references: a triangle must not outlive the points it was made from.
struct Triangle {
    const Point3D& v1;
    const Point3D& v2;
    const Point3D& v3;

    /// The edges that leave the first corner. They follow from the corners; never set them.
    const Vector3D v1v2{v2 - v1};
    const Vector3D v1v3{v3 - v1};
};
