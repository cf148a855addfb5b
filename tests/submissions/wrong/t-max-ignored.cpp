// expect: hits.special-rays
// untouched: a
// mistake: The search starts with infinity instead of t_max.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <cmath>
#include <queue>
#include <vector>

void BVH::construct(const Mesh& mesh)
{
    const uint32_t numFaces = uint32_t(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);

    nodes.clear();
    nodes.resize(2 * roundUpPowerOfTwo((numFaces + numFacesPerLeaf - 1) / numFacesPerLeaf) - 1);
    nodes[0] = Node{mesh.getBounds(), 0, numFaces};

    for (uint32_t depth = 0; depth < maxDepth; ++depth) {
        const uint32_t first = (1u << depth) - 1;
        for (uint32_t i = first; i <= 2 * first && 2 * i + 2 < nodes.size(); ++i) {
            const Node& node = nodes[i];
            if (node.facesEnd - node.facesBegin <= numFacesPerLeaf)
                continue;
            const auto faces = getFaceIndices(node);
            const auto axis = node.bounds.extents().maxDimension();
            const auto half = faces.size() / 2;
            auto key = [&](uint32_t f) { const auto t = mesh.getTriangleFromFaceIndex(f); return ((t.v1 + t.v2 + t.v3) / 3)[axis]; };
            std::nth_element(faces.begin(), faces.begin() + half, faces.end(), [&](auto a, auto b) { return key(a) < key(b); });

            Node& left = nodes[2 * i + 1];
            Node& right = nodes[2 * i + 2];
            left.facesBegin = node.facesBegin;
            left.facesEnd = right.facesBegin = node.facesBegin + uint32_t(half);
            right.facesEnd = node.facesEnd;
            for (size_t k = 0; k < faces.size(); ++k) {
                const auto t = mesh.getTriangleFromFaceIndex(faces[k]);
                AABB& box = k < half ? left.bounds : right.bounds;
                box.extend(t.v1); box.extend(t.v2); box.extend(t.v3);
            }
        }
    }
}

static bool boxHit(const AABB& box, const IntersectionRay& ray)
{
    float t0 = ray.t_min, t1 = infinity;
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
    if (!(t > ray.t_min && t < closest))
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
    float closest = infinity;
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
