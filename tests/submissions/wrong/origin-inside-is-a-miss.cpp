// expect: hits.special-rays
// untouched: a
// mistake: The own box test wants the entry to lie before the ray, so a box around the origin is missed.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <algorithm>
#include <cmath>
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

static bool hitsBox(const AABB& box, const IntersectionRay& ray, float closest)
{
    float enter = ray.t_min;
    float leave = std::min(ray.t_max, closest);
    for (int axis = 0; axis < 3; ++axis) {
        if (ray.direction[axis] == 0.0f) {
            if (ray.origin[axis] < box.min[axis] || ray.origin[axis] > box.max[axis])
                return false;
            continue;
        }
        float t0 = (box.min[axis] - ray.origin[axis]) / ray.direction[axis];
        float t1 = (box.max[axis] - ray.origin[axis]) / ray.direction[axis];
        if (t0 > t1)
            std::swap(t0, t1);
        // a little slack against rounding
        enter = std::max(enter, t0 - 1e-6f * std::abs(t0));
        leave = std::min(leave, t1 + 1e-6f * std::abs(t1));
    }
    return enter <= leave && enter > ray.t_min;
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    const auto& nodes = mesh.getBVH().getNodes();
    if (nodes.empty())
        return best;
    std::vector<uint32_t> todo{0};
    while (!todo.empty()) {
        const uint32_t i = todo.back();
        todo.pop_back();
        if (!hitsBox(nodes[i].bounds, ray, best.t + 1e-5f * std::abs(best.t)))
            continue;
        if (2 * i + 1 < nodes.size() && nodes[2 * i + 1].facesEnd != 0) {
            todo.push_back(2 * i + 2);
            todo.push_back(2 * i + 1);
        } else {
            for (uint32_t face : mesh.getBVH().getFaceIndices(nodes[i])) {
                const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
                if (hit.t < best.t)
                    best = hit;
            }
        }
    }
    return best;
}
