// expect: work.excludes-most-triangles
// untouched: a
// mistake: A vector with one result for every face of the mesh is made for each ray, and its minimum is taken.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <algorithm>
#include <numeric>
#include <queue>
#include <stack>

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

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection closest;
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    if (nodes.empty())
        return closest;

    std::vector<Intersection> hits(mesh.getFaces().size());
    std::stack<size_t> todo;
    todo.push(0);
    while (!todo.empty()) {
        const size_t index = todo.top();
        todo.pop();
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
            hits[face] = intersect(mesh.getTriangleFromFaceIndex(face), ray);
        }
    }
    for (const Intersection& hit : hits)
        if (hit.t < closest.t)
            closest = hit;
    return closest;
}
