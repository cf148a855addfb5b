// expect: hits.survives-every-ray
// untouched: a
// mistake: The node is never taken from the stack.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <algorithm>
#include <numeric>
#include <queue>
#include <stack>
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

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection closest;
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    if (nodes.empty())
        return closest;

    std::stack<size_t> todo;
    todo.push(0);
    while (!todo.empty()) {
        const size_t index = todo.top();
        if (!intersect(nodes[index].bounds, ray))
            continue;
        const size_t left = 2 * index + 1;
        const size_t right = left + 1;
        if (right < nodes.size() && nodes[left].facesEnd != 0 && nodes[right].facesEnd != 0) {
            todo.push(right);
            todo.push(left);
            continue;
        }
        for (uint32_t face : bvh.getFaceIndices(nodes[index])) {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
            if (hit.t < closest.t)
                closest = hit;
        }
    }
    return closest;
}
