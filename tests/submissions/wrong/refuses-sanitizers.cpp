// expect: bvh.memory-is-safe, hits.memory-is-safe
// untouched: -
// mistake: It refuses to be compiled with sanitizers, so nobody can tell whether its memory is safe.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <algorithm>
#include <queue>
#include <vector>

#ifdef __SANITIZE_ADDRESS__
#error "too slow with sanitizers"
#endif

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
        std::nth_element(faces.begin(), faces.begin() + size / 2, faces.end(),
                         [&centers, axis](uint32_t a, uint32_t b) { return centers[a][axis] < centers[b][axis]; });

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
    const auto& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    std::queue<uint32_t> open;
    if (!nodes.empty() && nodes[0].facesEnd > 0)
        open.push(0);
    for (; !open.empty(); open.pop()) {
        const uint32_t i = open.front();
        if (!intersect(nodes[i].bounds, ray))
            continue;
        if (const uint32_t left = 2 * i + 1; left < nodes.size() && nodes[left].facesEnd != 0) {
            open.push(left);
            open.push(left + 1);
            continue;
        }
        for (uint32_t f : bvh.getFaceIndices(nodes[i]))
            if (auto hit = intersect(mesh.getTriangleFromFaceIndex(f), ray); hit.t < closest.t)
                closest = hit;
    }
    return closest;
}
