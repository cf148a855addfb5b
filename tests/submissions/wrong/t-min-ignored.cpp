// expect: hits.special-rays
// untouched: a
// mistake: The own triangle test compares t with zero instead of t_min.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <cmath>
#include <vector>

void BVH::construct(const Mesh& mesh)
{
    const uint32_t n = uint32_t(mesh.getFaces().size());
    *this = {};
    faceIndices.resize(n);
    for (uint32_t i = 0; i < n; ++i)
        faceIndices[i] = i;
    nodes.push_back({mesh.getBounds(), 0, n});

    const size_t firstOfLastLevel = (size_t(1) << maxDepth) - 1;
    for (size_t i = 0; i < nodes.size() && i < firstOfLastLevel; ++i) {
        const uint32_t begin = nodes[i].facesBegin;
        const uint32_t end = nodes[i].facesEnd;
        if (end - begin <= numFacesPerLeaf)
            continue;
        const uint8_t axis = nodes[i].bounds.extents().maxDimension();
        const auto center = [&](uint32_t f) {
            const Triangle t = mesh.getTriangleFromFaceIndex(f);
            return (t.v1[axis] + t.v2[axis] + t.v3[axis]) * (1.f / 3.f);
        };
        const uint32_t mid = (begin + end) / 2;
        std::nth_element(faceIndices.begin() + begin, faceIndices.begin() + mid, faceIndices.begin() + end,
                         [&](uint32_t a, uint32_t b) { return center(a) < center(b); });
        const auto boxOf = [&](uint32_t from, uint32_t to) {
            AABB box;
            for (uint32_t k = from; k < to; ++k) {
                const Triangle t = mesh.getTriangleFromFaceIndex(faceIndices[k]);
                box.min = min(box.min, min(t.v1, min(t.v2, t.v3)));
                box.max = max(box.max, max(t.v1, max(t.v2, t.v3)));
            }
            return box;
        };
        nodes.resize(std::max(nodes.size(), 2 * i + 3));
        nodes[2 * i + 1] = Node{boxOf(begin, mid), begin, mid};
        nodes[2 * i + 2] = Node{boxOf(mid, end), mid, end};
    }
}

static bool boxHit(const AABB& box, const IntersectionRay& ray)
{
    float t0 = 0.f, t1 = ray.t_max;
    for (int k = 0; k < 3; ++k) {
        float a = (box.min[k] - ray.origin[k]) * ray.inv_direction[k];
        float b = (box.max[k] - ray.origin[k]) * ray.inv_direction[k];
        if (std::signbit(ray.inv_direction[k]))
            std::swap(a, b);
        // comparisons with NaN (0 * inf: the ray runs in the slab's plane) are false and keep t0 and t1
        b += 4e-7f * std::fabs(b);
        t0 = a > t0 ? a : t0;
        t1 = b < t1 ? b : t1;
    }
    return t0 <= t1;
}

static float triangleHit(const Triangle& tri, const IntersectionRay& ray, float closest)
{
    const Vector3D n = cross(tri.v1v2, tri.v1v3);
    const float t = dot(tri.v1 - ray.origin, n) / dot(ray.direction, n);
    if (!(t > 0.f && t < closest))
        return infinity;
    const Point3D p = ray.origin + t * ray.direction;
    if (dot(cross(tri.v1v2, p - tri.v1), n) < 0.f || dot(cross(tri.v3 - tri.v2, p - tri.v2), n) < 0.f ||
        dot(cross(tri.v1 - tri.v3, p - tri.v3), n) < 0.f)
        return infinity;
    return t;
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    if (nodes.empty())
        return best;
    float closest = ray.t_max;
    uint32_t stack[64];
    uint32_t size = 1;
    stack[0] = 0;
    while (size) {
        const uint32_t i = stack[--size];
        if (!boxHit(nodes[i].bounds, ray))
            continue;
        const uint32_t left = 2 * i + 1;
        if (left + 1 < nodes.size() && nodes[left].facesEnd) {
            stack[size++] = left + 1;
            stack[size++] = left;
            continue;
        }
        for (uint32_t face : bvh.getFaceIndices(nodes[i])) {
            const Triangle tri = mesh.getTriangleFromFaceIndex(face);
            const float t = triangleHit(tri, ray, closest);
            if (t < closest) {
                closest = best.t = t;
                best.normal = cross(tri.v1v2, tri.v1v3).normalized();
                best.intersection_point = ray.origin + t * ray.direction;
            }
        }
    }
    return best;
}
