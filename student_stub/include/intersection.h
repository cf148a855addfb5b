#pragma once

#include "aabb.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

/// Where a ray meets a surface first. A new one says that nothing was hit.
struct Intersection {
    Point3D intersection_point;
    float t{infinity};

    /// Perpendicular to the face, of length 1. The order of the corners decides to which side it
    /// points, and not the ray: it is never turned.
    Normal3D normal;

    /// True if something was hit.
    operator bool() const { return std::isfinite(t); }
};

/// Says whether any part of the ray between `t_min` and `t_max` lies in `box`.
///
/// A ray that starts inside or only touches the box counts. An empty box is never hit.
/// Rounding may let a ray hit that passes the box very closely, but never the other way round.
bool intersect(const AABB& box, const IntersectionRay& ray);

/// The hit of the ray with one triangle, from either side, if `t_min < t < t_max`.
///
/// A triangle without area is never hit.
Intersection intersect(const Triangle& triangle, const IntersectionRay& ray);

/// The closest hit of the ray with any face of the mesh. Exercise part b).
Intersection intersect(const Mesh& mesh, const IntersectionRay& ray);
