#include "aabb.h"

void AABB::extend(const Point3D& point) {
    min = ::min(min, point);
    max = ::max(max, point);
}

void AABB::extend(const AABB& other) {
    min = ::min(min, other.min);
    max = ::max(max, other.max);
}

Vector3D AABB::extents() const { return max - min; }

Point3D AABB::center() const { return (min + max) * 0.5f; }
