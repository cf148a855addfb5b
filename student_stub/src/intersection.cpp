#include "intersection.h"

#include "counters.h"
#include "path.h"

namespace ex03 {

constinit thread_local Counters counters;

namespace {

/// 2 * gamma(3) with gamma(n) = n u / (1 - n u), u = 2^-24: bounds the rounding of two slab
/// distances. T. Ize, Robust BVH Ray Traversal, JCGT 2(2), 2013, section 3.
constexpr float roundingUnit = std::numeric_limits<float>::epsilon() / 2;
constexpr float slabSlack = 2 * (3 * roundingUnit) / (1 - 3 * roundingUnit);

/// The part of a ray that is still inside of every slab looked at so far.
struct Interval {
    float near;
    float far;

    /// 0 * infinity is not a number: the ray runs in the slab's plane, which excludes nothing.
    /// `std::max` and `std::min` return their first argument then, so the order matters.
    void clip(float low, float high, float origin, float inverse) {
        near = std::max(near, ((inverse < 0 ? high : low) - origin) * inverse);
        far = std::min(far, ((inverse < 0 ? low : high) - origin) * inverse);
    }
};

} // namespace
} // namespace ex03

bool intersect(const AABB& box, const IntersectionRay& ray) {
    ++ex03::counters.boxes;
    const Vector3D& inverse = ray.inv_direction;
    ex03::Interval inside{ray.t_min, ray.t_max};
    inside.clip(box.min.x, box.max.x, ray.origin.x, inverse.x);
    inside.clip(box.min.y, box.max.y, ray.origin.y, inverse.y);
    inside.clip(box.min.z, box.max.z, ray.origin.z, inverse.z);
    // An entry at infinity belongs to a ray that runs beside the box, parallel to one of its sides.
    const bool hit = inside.near <= inside.far + std::abs(inside.far) * ex03::slabSlack &&
                     inside.near < infinity;
    if (ex03::path != nullptr) [[unlikely]] {
        ex03::path->add(box, ray, hit);
    }
    return hit;
}

namespace ex03 {
namespace {

Intersection tested(const Triangle& triangle, const IntersectionRay& ray) {
    const Vector3D normal = cross(triangle.v1v2, triangle.v1v3);
    const float t = dot(triangle.v1 - ray.origin, normal) / dot(ray.direction, normal);
    // Also false for not-a-number: a ray in the triangle's plane, or a triangle without area.
    if (!(ray.t_min < t && t < ray.t_max)) {
        return {};
    }
    const Point3D point = ray.origin + ray.direction * t;
    const Vector3D fromV1 = point - triangle.v1;
    const bool inside = dot(normal, cross(triangle.v1v2, fromV1)) >= 0 &&
                        dot(normal, cross(triangle.v3 - triangle.v2, point - triangle.v2)) >= 0 &&
                        dot(normal, cross(fromV1, triangle.v1v3)) >= 0;
    return inside ? Intersection{point, t, normal.normalized()} : Intersection{};
}

} // namespace
} // namespace ex03

Intersection intersect(const Triangle& triangle, const IntersectionRay& ray) {
    ++ex03::counters.triangles;
    const Intersection found = ex03::tested(triangle, ray);
    if (ex03::path != nullptr) [[unlikely]] {
        ex03::path->add(triangle, ray, found);
    }
    return found;
}
