// expect: hits.survives-every-ray
// untouched: a
// mistake: The face of the closest hit is used without asking whether there is one.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <cmath>
#include <deque>

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

static bool moellerTrumbore(const Triangle& triangle, const IntersectionRay& ray, float tMax, float& t)
{
    const Vector3D p = cross(ray.direction, triangle.v1v3);
    const float det = dot(triangle.v1v2, p);
    if (det == 0.0f)
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
    const TriangleIndices* bestFace = nullptr;
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
                bestFace = &mesh.getFaces()[face];
            }
        }
    }
    const Point3D corner = mesh.getVertices()[bestFace->v1];
    best.intersection_point = corner;
    if (closest < ray.t_max) {
        const Triangle triangle = mesh.getTriangleFromFace(*bestFace);
        best.t = closest;
        best.intersection_point = ray.origin + ray.direction * closest;
        best.normal = cross(triangle.v1v2, triangle.v1v3).normalized();
    }
    return best;
}
