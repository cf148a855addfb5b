// expect: hits.calls-are-independent
// untouched: a
// mistake: Results are cached by origin and direction, whatever the mesh.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <algorithm>
#include <array>
#include <bit>
#include <map>
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

static void visit(const Mesh& mesh, const IntersectionRay& ray, size_t index, Intersection& best)
{
    const auto& nodes = mesh.getBVH().getNodes();
    if (!intersect(nodes[index].bounds, ray))
        return;
    if (2 * index + 1 >= nodes.size() || nodes[2 * index + 1].facesEnd == 0) {
        for (uint32_t f : mesh.getBVH().getFaceIndices(nodes[index])) {
            Intersection hit = intersect(mesh.getTriangleFromFaceIndex(f), ray);
            if (hit.t < best.t)
                best = hit;
        }
        return;
    }
    visit(mesh, ray, 2 * index + 1, best);
    visit(mesh, ray, 2 * index + 2, best);
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    using Key = std::array<float, 8>;
    thread_local std::map<Key, Intersection> cache;
    const Key key{ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z, ray.t_min, ray.t_max};
    if (const auto found = cache.find(key); found != cache.end())
        return found->second;
    Intersection best;
    if (!mesh.getBVH().getNodes().empty())
        visit(mesh, ray, 0, best);
    cache[key] = best;
    return best;
}
