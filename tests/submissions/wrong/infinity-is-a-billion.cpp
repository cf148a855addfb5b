// expect: hits.special-rays
// untouched: a
// mistake: The search starts with 1e9 as if it were infinity, so hits with a larger t are lost.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <cmath>
#include <vector>

void BVH::construct(const Mesh& mesh)
{
    const uint32_t numFaces = uint32_t(mesh.getFaces().size());
    std::vector<Point3D> center(numFaces);
    std::vector<AABB> box(numFaces);
    faceIndices.resize(numFaces);
    for (uint32_t f = 0; f < numFaces; ++f) {
        const Triangle t = mesh.getTriangleFromFaceIndex(f);
        center[f] = (t.v1 + t.v2 + t.v3) / 3.f;
        box[f].extend(t.v1);
        box[f].extend(t.v2);
        box[f].extend(t.v3);
        faceIndices[f] = f;
    }
    nodes.clear();
    nodes.push_back(Node{mesh.getBounds(), 0, numFaces});
    std::vector<uint32_t> todo{0};
    for (size_t done = 0; done < todo.size(); ++done) {
        const uint32_t i = todo[done];
        const Node node = nodes[i];
        const uint32_t count = node.facesEnd - node.facesBegin;
        if (count <= numFacesPerLeaf || i + 1 >= (1u << maxDepth))
            continue;
        const auto faces = getFaceIndices(node);
        const auto axis = node.bounds.extents().maxDimension();
        std::nth_element(faces.begin(), faces.begin() + count / 2, faces.end(),
                         [&](uint32_t a, uint32_t b) { return center[a][axis] < center[b][axis]; });
        if (nodes.size() < 2 * i + 3)
            nodes.resize(2 * i + 3);
        nodes[2 * i + 1] = Node{{}, node.facesBegin, node.facesBegin + count / 2};
        nodes[2 * i + 2] = Node{{}, node.facesBegin + count / 2, node.facesEnd};
        for (uint32_t child : {2 * i + 1, 2 * i + 2}) {
            for (uint32_t f : getFaceIndices(nodes[child]))
                nodes[child].bounds.extend(box[f]);
            todo.push_back(child);
        }
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
    float closest = std::min(ray.t_max, 1e9f);
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
