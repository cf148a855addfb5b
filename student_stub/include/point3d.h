#pragma once

#include "common.h"

/// Three coordinates: a point, a direction or a normal, whichever name is used for it.
struct Point3D {
    float x{0};
    float y{0};
    float z{0};

    /// Coordinate 0, 1 or 2, that is x, y or z.
    float& operator[](size_t axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    float operator[](size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }

    Point3D operator-() const { return {-x, -y, -z}; }

    /// Component by component, the product and the quotient too.
    Point3D operator+(const Point3D& b) const { return {x + b.x, y + b.y, z + b.z}; }
    Point3D operator-(const Point3D& b) const { return {x - b.x, y - b.y, z - b.z}; }
    Point3D operator*(const Point3D& b) const { return {x * b.x, y * b.y, z * b.z}; }
    Point3D operator/(const Point3D& b) const { return {x / b.x, y / b.y, z / b.z}; }

    /// The same number for all three components.
    Point3D operator+(float s) const { return {x + s, y + s, z + s}; }
    Point3D operator-(float s) const { return {x - s, y - s, z - s}; }
    Point3D operator*(float s) const { return {x * s, y * s, z * s}; }
    Point3D operator/(float s) const { return {x / s, y / s, z / s}; }

    /// Exactly equal in every component: no tolerance, and not-a-number equals nothing.
    bool operator==(const Point3D& other) const = default;

    /// Length of the vector.
    float norm() const { return std::sqrt(x * x + y * y + z * z); }

    /// The vector of length 1 in the same direction. Not a number if the length is 0.
    Point3D normalized() const { return *this / norm(); }

    /// Index of the largest component; the first of them if several are equal.
    uint8_t maxDimension() const { return x >= y && x >= z ? 0 : y >= z ? 1 : 2; }

    float maxComponent() const { return std::max({x, y, z}); }
    float minComponent() const { return std::min({x, y, z}); }
};

using Vector3D = Point3D;
using Normal3D = Point3D;
using Vertex = Point3D;

// A template, so that it steps back where a submission defines an operator of its own.
template <typename Scalar>
    requires std::is_arithmetic_v<Scalar>
Point3D operator*(Scalar s, const Point3D& a) {
    return a * static_cast<float>(s);
}

inline float dot(const Vector3D& a, const Vector3D& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Perpendicular to both; its length is the area of the parallelogram between them.
inline Vector3D cross(const Vector3D& a, const Vector3D& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The smaller of both, component by component.
inline Point3D min(const Point3D& a, const Point3D& b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}

/// The larger of both, component by component.
inline Point3D max(const Point3D& a, const Point3D& b) {
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}
