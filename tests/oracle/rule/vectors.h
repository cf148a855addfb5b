#pragma once

#include <cmath>
#include <limits>

namespace rule {

template <typename Real> constexpr Real nothing = std::numeric_limits<Real>::infinity();

template <typename Real> struct Vec {
    Real x, y, z;

    Real operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    Vec operator+(const Vec& b) const { return {x + b.x, y + b.y, z + b.z}; }
    Vec operator-(const Vec& b) const { return {x - b.x, y - b.y, z - b.z}; }
    Vec operator*(Real s) const { return {x * s, y * s, z * s}; }
};

template <typename Real> Real dot(const Vec<Real>& a, const Vec<Real>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <typename Real> Vec<Real> cross(const Vec<Real>& a, const Vec<Real>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Index of the component that is farthest from 0.
template <typename Real> int largest(const Vec<Real>& a) {
    const Real x = std::abs(a.x), y = std::abs(a.y), z = std::abs(a.z);
    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

template <typename Real> struct Line {
    Vec<Real> o, d, inverse;
    Real t_min, t_max;
};

template <typename Real> struct Face {
    Vec<Real> v1, v2, v3;
};

template <typename Real> struct Box {
    Vec<Real> low, high;
};

} // namespace rule
