// expect: hits.record-is-complete
// untouched: a
// mistake: The normal is computed in the wrong order and points to the other side.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <cmath>
#include <deque>
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
        best.normal = cross(triangle.v1v3, triangle.v1v2).normalized();
    }
    return best;
}
