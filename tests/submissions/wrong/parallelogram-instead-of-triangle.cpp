// expect: hits.closest-wins, hits.misses-stay-infinite
// untouched: a
// mistake: The own triangle test checks u and v but not their sum.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <bit>
#include <cmath>
#include <deque>

void BVH::construct(const Mesh& mesh)
{
    uint32_t numFaces = mesh.getFaces().size();
    faceIndices.clear();
    for (uint32_t i = 0; i != numFaces; i++)
        faceIndices.push_back(i);
    nodes.clear();
    nodes.push_back(Node{mesh.getBounds(), 0, numFaces});

    for (uint32_t i = 0; i < nodes.size(); i++) {
        Node node = nodes[i];
        uint32_t level = std::bit_width(i + 1);  // 1 for the root
        if (level >= maxDepth || node.facesEnd - node.facesBegin <= numFacesPerLeaf)
            continue;

        Vector3D size = node.bounds.extents();
        int axis = 0;
        if (size.y > size[axis]) axis = 1;
        if (size.z > size[axis]) axis = 2;

        std::span<uint32_t> faces = getFaceIndices(node);
        size_t half = faces.size() / 2;
        std::nth_element(faces.begin(), faces.begin() + half, faces.end(), [&](uint32_t a, uint32_t b) {
            Triangle s = mesh.getTriangleFromFaceIndex(a);
            Triangle t = mesh.getTriangleFromFaceIndex(b);
            return s.v1[axis] / 3 + s.v2[axis] / 3 + s.v3[axis] / 3 < t.v1[axis] / 3 + t.v2[axis] / 3 + t.v3[axis] / 3;
        });

        if (nodes.size() < 2 * i + 3)
            nodes.resize(2 * i + 3);
        for (int side = 0; side < 2; side++) {
            Node& child = nodes[2 * i + 1 + side];
            child.facesBegin = node.facesBegin + (side ? half : 0);
            child.facesEnd = side ? node.facesEnd : node.facesBegin + half;
            child.bounds = AABB();
            for (uint32_t f : getFaceIndices(child)) {
                Triangle t = mesh.getTriangleFromFaceIndex(f);
                child.bounds.extend(t.v1);
                child.bounds.extend(t.v2);
                child.bounds.extend(t.v3);
            }
        }
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
    if (!(v >= 0.0f && v <= 1.0f))
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
