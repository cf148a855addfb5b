// expect: hits.special-rays
// untouched: a
// mistake: The own box test asks direction < 0, which is false for -0.0 though 1 / -0.0 is negative.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <cmath>
#include <vector>

void BVH::construct(const Mesh& mesh)
{
    nodes.clear();
    faceIndices.clear();
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    if (numFaces == 0)
        return;
    for (uint32_t i = 0; i < numFaces; ++i)
        faceIndices.push_back(i);
    nodes.push_back({mesh.getBounds(), 0, numFaces});

    auto makeNode = [&](uint32_t begin, uint32_t end) {
        Node node{{}, begin, end};
        for (auto face : getFaceIndices(node)) {
            auto triangle = mesh.getTriangleFromFaceIndex(face);
            node.bounds.extend(triangle.v1);
            node.bounds.extend(triangle.v2);
            node.bounds.extend(triangle.v3);
        }
        return node;
    };

    size_t levelBegin = 0;
    for (uint32_t depth = 0; depth < maxDepth; ++depth) {
        const size_t levelEnd = nodes.size();
        bool split = false;
        for (size_t i = levelBegin; i < levelEnd; ++i) {
            const Node node = nodes[i];
            if (node.facesEnd - node.facesBegin <= numFacesPerLeaf) {
                nodes.push_back(Node{});
                nodes.push_back(Node{});
                continue;
            }
            split = true;
            const uint32_t mid = node.facesBegin + (node.facesEnd - node.facesBegin) / 2;
            const uint8_t axis = node.bounds.extents().maxDimension();
            auto faces = getFaceIndices(node);
            std::nth_element(faces.begin(), faces.begin() + (mid - node.facesBegin), faces.end(),
                             [&](uint32_t a, uint32_t b) {
                                 auto s = mesh.getTriangleFromFaceIndex(a);
                                 auto t = mesh.getTriangleFromFaceIndex(b);
                                 const auto sum = [](const Triangle& x) { return x.v1 + x.v2 + x.v3; };
                                 return sum(s)[axis] < sum(t)[axis];
                             });
            nodes.push_back(makeNode(node.facesBegin, mid));
            nodes.push_back(makeNode(mid, node.facesEnd));
        }
        levelBegin = levelEnd;
        if (!split)
            break;
    }
    while (nodes.back().facesEnd == 0)
        nodes.pop_back();
}

static bool boxHit(const AABB& box, const IntersectionRay& ray)
{
    float t0 = ray.t_min, t1 = ray.t_max;
    for (int k = 0; k < 3; ++k) {
        float a = (box.min[k] - ray.origin[k]) * ray.inv_direction[k];
        float b = (box.max[k] - ray.origin[k]) * ray.inv_direction[k];
        if (ray.direction[k] < 0)
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
                best.intersection_point = ray.origin + t * ray.direction;
            }
        }
    }
    return best;
}
