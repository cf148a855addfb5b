#pragma once

#include "point3d.h"

/// The points `origin + t * direction` with `t_min < t < t_max`.
///
/// The direction need not have length 1: `t` counts in multiples of it.
struct Ray {
    Point3D origin;
    Vector3D direction;
    float t_min{epsilon};
    float t_max{infinity};
};

/// A ray that is ready to be tested against many boxes.
struct IntersectionRay final : Ray {
    /// 1 / direction. Infinite, with the right sign, where the direction is 0 or -0.
    const Vector3D inv_direction;

    /// Not explicit, so that any ray can be passed where an `IntersectionRay` is expected.
    IntersectionRay(const Ray& ray)
        : Ray(ray), inv_direction{1 / ray.direction.x, 1 / ray.direction.y, 1 / ray.direction.z} {}
};
