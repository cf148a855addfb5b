// expect: hits.closest-wins
// untouched: a
// mistake: The own triangle test rejects determinants below 1e-5, so small triangles vanish.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <vector>

namespace {
struct Job { size_t node; uint32_t depth; };
}

void BVH::construct(const Mesh& mesh)
{
    const size_t count = mesh.getFaces().size();
    std::vector<Point3D> centers;
    centers.reserve(count);
    faceIndices.clear();
    faceIndices.reserve(count);
    for (size_t i = 0; i < count; ++i) {
        const auto t = mesh.getTriangleFromFaceIndex(i);
        centers.push_back((t.v1 + t.v2 + t.v3) / 3.f);
        faceIndices.push_back(static_cast<uint32_t>(i));
    }

    nodes.clear();
    nodes.push_back(Node{.bounds = mesh.getBounds(), .facesBegin = 0, .facesEnd = static_cast<uint32_t>(count)});
    std::vector<Job> jobs{{0, 0}};
    while (!jobs.empty()) {
        const Job job = jobs.back();
        jobs.pop_back();
        const Node parent = nodes[job.node];
        const uint32_t size = parent.facesEnd - parent.facesBegin;
        if (size <= numFacesPerLeaf || job.depth == maxDepth)
            continue;

        const auto axis = parent.bounds.extents().maxDimension();
        auto faces = getFaceIndices(parent);
        std::sort(faces.begin(), faces.end(), [&centers, axis](uint32_t a, uint32_t b) { return centers[a][axis] < centers[b][axis]; });

        const uint32_t split = parent.facesBegin + size / 2;
        Node children[2] = {{AABB{}, parent.facesBegin, split}, {AABB{}, split, parent.facesEnd}};
        if (nodes.size() < 2 * job.node + 3)
            nodes.resize(2 * job.node + 3);
        for (size_t c = 0; c < 2; ++c) {
            for (uint32_t face : getFaceIndices(children[c])) {
                const auto t = mesh.getTriangleFromFaceIndex(face);
                AABB box;
                box.extend(t.v1);
                box.extend(t.v2);
                box.extend(t.v3);
                children[c].bounds.extend(box);
            }
            nodes[2 * job.node + 1 + c] = children[c];
            jobs.push_back({2 * job.node + 1 + c, job.depth + 1});
        }
    }
}

static bool moellerTrumbore(const Triangle& triangle, const IntersectionRay& ray, float tMax, float& t)
{
    const Vector3D p = cross(ray.direction, triangle.v1v3);
    const float det = dot(triangle.v1v2, p);
    if (det > -1e-5f && det < 1e-5f)
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
