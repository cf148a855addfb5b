// expect: hits.closest-wins
// untouched: a
// mistake: The own triangle test sees a triangle from one side only.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <cmath>
#include <deque>
#include <queue>

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

static bool moellerTrumbore(const Triangle& triangle, const IntersectionRay& ray, float tMax, float& t)
{
    const Vector3D p = cross(ray.direction, triangle.v1v3);
    const float det = dot(triangle.v1v2, p);
    if (det <= 0.0f)
        return false;
    const Vector3D s = ray.origin - triangle.v1;
    const float u = dot(s, p) / det;
    if (!(u >= 0.0f && u <= 1.0f))
        return false;
    const Vector3D q = cross(s, triangle.v1v2);
    const float v = dot(ray.direction, q) / det;
    if (!(v >= 0.0f && u + v <= 1.0f))
        return false;
    t = dot(triangle.v1v3, q) / det;
    return t > ray.t_min && t < tMax;
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    if (nodes.empty())
        return best;
    float closest = ray.t_max;
    uint32_t bestFace = 0;
    bool found = false;
    std::vector<uint32_t> todo = {0};
    while (!todo.empty()) {
        const uint32_t i = todo.back();
        todo.pop_back();
        if (!intersect(nodes[i].bounds, ray))
            continue;
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd > 0) {
            todo.insert(todo.end(), {2 * i + 1, 2 * i + 2});
            continue;
        }
        for (uint32_t face : bvh.getFaceIndices(nodes[i])) {
            float t;
            if (moellerTrumbore(mesh.getTriangleFromFaceIndex(face), ray, closest, t)) {
                closest = t;
                bestFace = face;
                found = true;
            }
        }
    }
    if (found) {
        const Triangle triangle = mesh.getTriangleFromFaceIndex(bestFace);
        best.t = closest;
        best.intersection_point = ray.origin + ray.direction * closest;
        best.normal = cross(triangle.v1v2, triangle.v1v3).normalized();
    }
    return best;
}
