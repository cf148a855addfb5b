#include "aabb.h"

Vector3D AABB::extents() const {
    return max - min;
}

Point3D AABB::center() const {
    return (min + max) * 0.5f;
}
