// expect: hits.special-rays
// untouched: a
// mistake: A hit less than epsilon before t_max is rejected.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <cmath>
#include <deque>

static float middle(const Mesh& mesh, uint32_t face, uint8_t axis)
{
    const TriangleIndices& f = mesh.getFaces()[face];
    const auto& v = mesh.getVertices();
    return (v[f.v1][axis] + v[f.v2][axis] + v[f.v3][axis]) / 3.f;
}

void BVH::construct(const Mesh& mesh)
{
    *this = {};
    for (uint32_t i = 0; i < mesh.getFaces().size(); ++i)
        faceIndices.push_back(i);
    nodes.push_back(Node{mesh.getBounds(), 0, static_cast<uint32_t>(faceIndices.size())});

    struct Task { uint32_t index, depth; };
    std::deque<Task> tasks{{0, 0}};
    while (!tasks.empty()) {
        const Task task = tasks.front();
        tasks.pop_front();
        const Node node = nodes[task.index];
        const auto faces = getFaceIndices(node);
        if (faces.size() <= numFacesPerLeaf || task.depth >= maxDepth)
            continue;
        const uint8_t axis = node.bounds.extents().maxDimension();
        const auto half = faces.begin() + std::ptrdiff_t(faces.size() / 2);
        std::nth_element(faces.begin(), half, faces.end(),
                         [&](uint32_t a, uint32_t b) { return middle(mesh, a, axis) < middle(mesh, b, axis); });
        if (2 * task.index + 3 > nodes.size())
            nodes.resize(2 * task.index + 3);
        const uint32_t border = node.facesBegin + uint32_t(faces.size() / 2);
        for (uint32_t side : {1u, 2u}) {
            Node child;
            child.facesBegin = side == 1 ? node.facesBegin : border;
            child.facesEnd = side == 1 ? border : node.facesEnd;
            for (uint32_t face : getFaceIndices(child)) {
                const TriangleIndices f = mesh.getFaces()[face];
                for (uint32_t v : {f.v1, f.v2, f.v3})
                    child.bounds.extend(mesh.getVertices()[v]);
            }
            nodes[2 * task.index + side] = child;
            tasks.push_back({2 * task.index + side, task.depth + 1});
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
    if (!(v >= 0.0f && u + v <= 1.0f))
        return false;
    t = dot(triangle.v1v3, q) / det;
    return t > ray.t_min && t < tMax && t < ray.t_max - epsilon;
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
