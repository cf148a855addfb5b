#pragma once

#include <algorithm>

#include "aabb.h"
#include "intersection.h"
#include "vectors.h"

/// Ways to write the slab test. None of them may lose a box that the ray enters.
namespace rule {

template <typename Real> using BoxTest = bool (*)(const Box<Real>&, const Line<Real>&);

/// The exercise's own, which takes float only.
inline bool given(const Box<float>& box, const Line<float>& ray) {
    const AABB bounds{{box.low.x, box.low.y, box.low.z}, {box.high.x, box.high.y, box.high.z}};
    const Ray same{{ray.o.x, ray.o.y, ray.o.z}, {ray.d.x, ray.d.y, ray.d.z}, ray.t_min, ray.t_max};
    return intersect(bounds, IntersectionRay(same));
}

/// Dividing by the direction; a ray parallel to a slab is inside of it or not.
template <typename Real> bool byDivision(const Box<Real>& box, const Line<Real>& ray) {
    Real near = ray.t_min, far = ray.t_max;
    for (int axis = 0; axis < 3; ++axis) {
        if (ray.d[axis] == 0) {
            if (ray.o[axis] < box.low[axis] || ray.o[axis] > box.high[axis]) {
                return false;
            }
            continue;
        }
        Real one = (box.low[axis] - ray.o[axis]) / ray.d[axis];
        Real two = (box.high[axis] - ray.o[axis]) / ray.d[axis];
        if (one > two) {
            std::swap(one, two);
        }
        near = one > near ? one : near;
        far = two < far ? two : far;
        if (near > far) {
            return false;
        }
    }
    return true;
}

/// `value`, or `otherwise` for 0 * infinity: the ray runs in the slab's plane.
template <typename Real> Real known(Real value, Real otherwise) {
    return value == value ? value : otherwise;
}

/// Multiplying by the inverse, without branches; not-a-number excludes nothing.
template <typename Real> bool byMinAndMax(const Box<Real>& box, const Line<Real>& ray) {
    Real near = ray.t_min, far = ray.t_max;
    for (int axis = 0; axis < 3; ++axis) {
        const Real one = (box.low[axis] - ray.o[axis]) * ray.inverse[axis];
        const Real two = (box.high[axis] - ray.o[axis]) * ray.inverse[axis];
        near = std::max(near, std::min(known(one, -nothing<Real>), known(two, -nothing<Real>)));
        far = std::min(far, std::max(known(one, nothing<Real>), known(two, nothing<Real>)));
    }
    return near <= far;
}

/// Choosing the near side by the sign of the inverse, and a box that is a little too large.
template <typename Real> bool bySign(const Box<Real>& box, const Line<Real>& ray) {
    Real near = ray.t_min, far = ray.t_max;
    for (int axis = 0; axis < 3; ++axis) {
        const bool back = ray.inverse[axis] < 0;
        const Real one = ((back ? box.high : box.low)[axis] - ray.o[axis]) * ray.inverse[axis];
        const Real two = ((back ? box.low : box.high)[axis] - ray.o[axis]) * ray.inverse[axis];
        near = one > near ? one : near;
        far = two < far ? two : far;
    }
    return near <= far * (far > 0 ? Real(1.000001) : Real(0.999999));
}

} // namespace rule
