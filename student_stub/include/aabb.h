#pragma once

#include "point3d.h"

/// An axis-aligned box, given by its two extreme corners.
///
/// A new box is empty: `min` is +infinity and `max` is -infinity, so that extending it by the
/// first point gives exactly that point.
struct AABB {
    Point3D min{+infinity, +infinity, +infinity};
    Point3D max{-infinity, -infinity, -infinity};

    /// Grows the box just enough to contain `point`.
    void extend(const Point3D& point) {
        min = ::min(min, point);
        max = ::max(max, point);
    }

    /// Grows the box just enough to contain `other`. An empty `other` changes nothing.
    void extend(const AABB& other) {
        min = ::min(min, other.min);
        max = ::max(max, other.max);
    }

    /// Side lengths along x, y and z. Negative infinity on each axis if the box is empty.
    Vector3D extents() const;

    /// Midpoint of the two corners. Not a number if the box is empty.
    Point3D center() const;
};
