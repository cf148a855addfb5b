#pragma once

#include "intersection.h"
#include "triangle.h"
#include "vectors.h"

/// Ways in which students, textbooks and libraries write the triangle test. Each returns t, or
/// `nothing` where there is no hit between t_min and t_max.
namespace rule {

template <typename Real> Real limited(Real t, const Line<Real>& ray) {
    return ray.t_min < t && t < ray.t_max ? t : nothing<Real>;
}

/// Whether p is on the inner side of all edges, by cross products. False for not-a-number.
template <typename Real>
bool isInside(const Face<Real>& f, const Vec<Real>& n, const Vec<Real>& p) {
    return dot(n, cross(f.v2 - f.v1, p - f.v1)) >= 0 && dot(n, cross(f.v3 - f.v2, p - f.v2)) >= 0 &&
           dot(n, cross(f.v1 - f.v3, p - f.v3)) >= 0;
}

template <typename Real>
Real hitInside(const Face<Real>& f, const Line<Real>& ray, const Vec<Real>& n, Real t) {
    return isInside(f, n, ray.o + ray.d * t) ? limited(t, ray) : nothing<Real>;
}

/// The exercise's own.
template <typename Real> struct Given {
    static Real t(const Face<Real>& f, const Line<Real>& ray) {
        const Point3D v1{f.v1.x, f.v1.y, f.v1.z}, v2{f.v2.x, f.v2.y, f.v2.z};
        const Point3D v3{f.v3.x, f.v3.y, f.v3.z};
        const Ray given{{ray.o.x, ray.o.y, ray.o.z}, {ray.d.x, ray.d.y, ray.d.z}, ray.t_min,
                        ray.t_max};
        return intersect(Triangle{v1, v2, v3, v2 - v1, v3 - v1}, IntersectionRay(given)).t;
    }
};

template <typename Real> struct PlaneAtV1 {
    static Real t(const Face<Real>& f, const Line<Real>& ray) {
        const Vec<Real> n = cross(f.v2 - f.v1, f.v3 - f.v1);
        return hitInside(f, ray, n, dot(f.v1 - ray.o, n) / dot(ray.d, n));
    }
};

/// Another corner, with the edges that meet there.
template <typename Real> struct PlaneAtV3 {
    static Real t(const Face<Real>& f, const Line<Real>& ray) {
        const Vec<Real> n = cross(f.v1 - f.v3, f.v2 - f.v3);
        return hitInside(f, ray, n, dot(f.v3 - ray.o, n) / dot(ray.d, n));
    }
};

/// The normal is made a unit vector first.
template <typename Real> struct PlaneOfUnitNormal {
    static Real t(const Face<Real>& f, const Line<Real>& ray) {
        const Vec<Real> n = cross(f.v2 - f.v1, f.v3 - f.v1);
        const Vec<Real> unit = n * (1 / std::sqrt(dot(n, n)));
        return hitInside(f, ray, unit, dot(f.v1 - ray.o, unit) / dot(ray.d, unit));
    }
};

/// The plane as n . p = c, from a textbook: loses digits where o is far from the world's origin.
template <typename Real> struct PlaneOfConstant {
    static Real t(const Face<Real>& f, const Line<Real>& ray) {
        const Vec<Real> n = cross(f.v2 - f.v1, f.v3 - f.v1);
        return hitInside(f, ray, n, (dot(n, f.v1) - dot(n, ray.o)) / dot(n, ray.d));
    }
};

/// T. Moeller, B. Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, 1997.
template <typename Real> struct MoellerTrumbore {
    static Real t(const Face<Real>& f, const Line<Real>& ray) {
        const Vec<Real> e1 = f.v2 - f.v1, e2 = f.v3 - f.v1, p = cross(ray.d, e2);
        const Real det = dot(e1, p);
        if (det == 0) {
            return nothing<Real>;
        }
        const Vec<Real> s = ray.o - f.v1, q = cross(s, e1);
        const Real inverse = 1 / det, u = dot(s, p) * inverse, v = dot(ray.d, q) * inverse;
        return u >= 0 && v >= 0 && u + v <= 1 ? limited(dot(e2, q) * inverse, ray) : nothing<Real>;
    }
};

/// The same, but the third edge belongs to the neighbour: all is hit once on a closed surface.
template <typename Real> struct HalfOpen {
    static Real t(const Face<Real>& f, const Line<Real>& ray) {
        const Vec<Real> e1 = f.v2 - f.v1, e2 = f.v3 - f.v1, p = cross(ray.d, e2);
        const Vec<Real> s = ray.o - f.v1, q = cross(s, e1);
        const Real det = dot(e1, p), u = dot(s, p) / det, v = dot(ray.d, q) / det;
        return u >= 0 && v >= 0 && u + v < 1 ? limited(dot(e2, q) / det, ray) : nothing<Real>;
    }
};

/// S. Woop, C. Benthin, I. Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013.
template <typename Real> struct Watertight {
    static Real t(const Face<Real>& f, const Line<Real>& ray) {
        const int z = largest(ray.d);
        const int x = ray.d[z] < 0 ? (z + 2) % 3 : (z + 1) % 3, y = 3 - z - x;
        const Real sx = ray.d[x] / ray.d[z], sy = ray.d[y] / ray.d[z], sz = 1 / ray.d[z];
        const Vec<Real> a = f.v1 - ray.o, b = f.v2 - ray.o, c = f.v3 - ray.o;
        const Real ax = a[x] - sx * a[z], ay = a[y] - sy * a[z];
        const Real bx = b[x] - sx * b[z], by = b[y] - sy * b[z];
        const Real cx = c[x] - sx * c[z], cy = c[y] - sy * c[z];
        const Real u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
        const Real det = u + v + w;
        if (((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) || det == 0) {
            return nothing<Real>;
        }
        return limited((u * a[z] + v * b[z] + w * c[z]) * sz / det, ray);
    }
};

/// Barycentric coordinates by dot products. C. Ericson, Real-Time Collision Detection, 3.4.
template <typename Real> struct DotBarycentrics {
    static Real t(const Face<Real>& f, const Line<Real>& ray) {
        const Vec<Real> e1 = f.v2 - f.v1, e2 = f.v3 - f.v1, n = cross(e1, e2);
        const Real t = dot(f.v1 - ray.o, n) / dot(ray.d, n);
        const Vec<Real> p = ray.o + ray.d * t - f.v1;
        const Real d11 = dot(e1, e1), d12 = dot(e1, e2), d22 = dot(e2, e2);
        const Real p1 = dot(p, e1), p2 = dot(p, e2), det = d11 * d22 - d12 * d12;
        const Real v = (d22 * p1 - d12 * p2) / det, w = (d11 * p2 - d12 * p1) / det;
        return v >= 0 && w >= 0 && v + w <= 1 ? limited(t, ray) : nothing<Real>;
    }
};

/// Barycentric coordinates as areas of the parts against the whole.
template <typename Real> struct AreaBarycentrics {
    static Real t(const Face<Real>& f, const Line<Real>& ray) {
        const Vec<Real> e1 = f.v2 - f.v1, e2 = f.v3 - f.v1, n = cross(e1, e2);
        const Real t = dot(f.v1 - ray.o, n) / dot(ray.d, n), whole = dot(n, n);
        const Vec<Real> p = ray.o + ray.d * t - f.v1;
        const Real v = dot(cross(p, e2), n) / whole, w = dot(cross(e1, p), n) / whole;
        return v >= 0 && w >= 0 && 1 - v - w >= 0 ? limited(t, ray) : nothing<Real>;
    }
};

/// In the coordinate plane that the face is seen largest from. D. Badouel, Graphics Gems, 1990.
template <typename Real> struct ProjectedBarycentrics {
    static Real t(const Face<Real>& f, const Line<Real>& ray) {
        const Vec<Real> e1 = f.v2 - f.v1, e2 = f.v3 - f.v1, n = cross(e1, e2);
        const Real t = dot(f.v1 - ray.o, n) / dot(ray.d, n);
        const Vec<Real> p = ray.o + ray.d * t - f.v1;
        const int z = largest(n), x = (z + 1) % 3, y = (z + 2) % 3;
        const Real det = e1[x] * e2[y] - e1[y] * e2[x];
        const Real v = (p[x] * e2[y] - p[y] * e2[x]) / det;
        const Real w = (e1[x] * p[y] - e1[y] * p[x]) / det;
        return v >= 0 && w >= 0 && v + w <= 1 ? limited(t, ray) : nothing<Real>;
    }
};

/// o + t d = v1 + v e1 + w e2 by Cramer's rule.
template <typename Real> struct Cramer {
    static Real t(const Face<Real>& f, const Line<Real>& ray) {
        const Vec<Real> e1 = f.v1 - f.v2, e2 = f.v1 - f.v3, s = f.v1 - ray.o;
        const Real det = dot(e1, cross(e2, ray.d));
        const Real v = dot(s, cross(e2, ray.d)) / det, w = dot(e1, cross(s, ray.d)) / det;
        const Real t = dot(e1, cross(e2, s)) / det;
        return v >= 0 && w >= 0 && v + w <= 1 ? limited(t, ray) : nothing<Real>;
    }
};

/// On which side of the ray each edge runs: signs of volumes, as in Embree's robust mode. From two
/// corners instead of an edge and a sum they err by u s^2 / |e|, more than the rule allows.
template <typename Real> struct Volumes {
    static Real t(const Face<Real>& f, const Line<Real>& ray) {
        const Vec<Real> a = f.v1 - ray.o, b = f.v2 - ray.o, c = f.v3 - ray.o;
        const Vec<Real> ca = c - a, ab = a - b, bc = b - c;
        const Real u = dot(ray.d, cross(ca, c + a)), v = dot(ray.d, cross(ab, a + b));
        const Real w = dot(ray.d, cross(bc, b + c));
        const bool same = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
        const Vec<Real> n = cross(ca, ab);
        return same ? limited(dot(a, n) / dot(ray.d, n), ray) : nothing<Real>;
    }
};

} // namespace rule
