// expect: hits.record-is-complete
// untouched: a
// mistake: The intersection point is t * direction, the origin is forgotten.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <stack>
#include <vector>

Point3D triangleCenter(const Triangle& triangle)
{
    return (triangle.v1 + triangle.v2 + triangle.v3) / 3.0f;
}

void BVH::construct(const Mesh& mesh)
{
    const uint32_t numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.assign(1, Node{mesh.getBounds(), 0, numFaces});

    struct Entry { uint32_t node; uint32_t depth; };
    std::queue<Entry> todo;
    todo.push({0, 0});
    while (!todo.empty()) {
        const Entry entry = todo.front();
        todo.pop();
        const Node node = nodes[entry.node];
        if (node.facesEnd - node.facesBegin <= numFacesPerLeaf || entry.depth >= maxDepth)
            continue;

        const uint8_t axis = node.bounds.extents().maxDimension();
        const uint32_t middle = node.facesBegin + (node.facesEnd - node.facesBegin) / 2;
        std::nth_element(faceIndices.begin() + node.facesBegin, faceIndices.begin() + middle,
                         faceIndices.begin() + node.facesEnd, [&](uint32_t a, uint32_t b) {
                             return triangleCenter(mesh.getTriangleFromFaceIndex(a))[axis] <
                                    triangleCenter(mesh.getTriangleFromFaceIndex(b))[axis];
                         });

        Node left{AABB{}, node.facesBegin, middle};
        Node right{AABB{}, middle, node.facesEnd};
        for (Node* child : {&left, &right})
            for (uint32_t face : getFaceIndices(*child)) {
                const Triangle triangle = mesh.getTriangleFromFaceIndex(face);
                child->bounds.extend(triangle.v1);
                child->bounds.extend(triangle.v2);
                child->bounds.extend(triangle.v3);
            }

        const uint32_t leftIndex = 2 * entry.node + 1;
        if (nodes.size() < leftIndex + 2)
            nodes.resize(leftIndex + 2);
        nodes[leftIndex] = left;
        nodes[leftIndex + 1] = right;
        todo.push({leftIndex, entry.depth + 1});
        todo.push({leftIndex + 1, entry.depth + 1});
    }
}

static bool boxHit(const AABB& box, const IntersectionRay& ray)
{
    float t0 = ray.t_min, t1 = ray.t_max;
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
                best.intersection_point = t * ray.direction;
            }
        }
    }
    return best;
}
