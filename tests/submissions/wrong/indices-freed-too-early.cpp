// expect: bvh.memory-is-safe
// untouched: b
// mistake: The last index is read through a pointer into a vector that has been moved meanwhile.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <algorithm>
#include <iostream>
#include <vector>

#define LEFT(i) (2 * (i) + 1)
#define RIGHT(i) (2 * (i) + 2)

void BVH::construct(const Mesh& mesh)
{
    nodes.clear();
    faceIndices.clear();
    const size_t numFaces = mesh.getFaces().size();
    if (numFaces == 0)
        return;
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);

    const uint32_t* before = faceIndices.data();
    faceIndices.reserve(numFaces + 1);
    if (before[numFaces - 1] == 0xffffffff)
        std::cout << "too many faces\n";

    struct Range { size_t node, begin, end, depth; } stack[64];
    int top = 0;
    stack[top++] = {0, 0, numFaces, 0};
    while (top > 0) {
        const Range r = stack[--top];
        if (nodes.size() <= r.node)
            nodes.resize(r.node + 1);
        Node& node = nodes[r.node];
        node.facesBegin = static_cast<uint32_t>(r.begin);
        node.facesEnd = static_cast<uint32_t>(r.end);
        for (size_t k = r.begin; k < r.end; k++) {
            const Triangle t = mesh.getTriangleFromFaceIndex(faceIndices[k]);
            node.bounds.extend(t.v1);
            node.bounds.extend(t.v2);
            node.bounds.extend(t.v3);
        }
        if (r.end - r.begin <= numFacesPerLeaf || r.depth >= maxDepth)
            continue;
        const auto axis = node.bounds.extents().maxDimension();
        const size_t mid = (r.begin + r.end) / 2;
        uint32_t* data = faceIndices.data();
        std::nth_element(data + r.begin, data + mid, data + r.end, [&](uint32_t a, uint32_t b) {
            const TriangleIndices f = mesh.getFaces()[a], g = mesh.getFaces()[b];
            const auto& v = mesh.getVertices();
            return (v[f.v1] + v[f.v2] + v[f.v3])[axis] * (1.0f / 3.0f) < (v[g.v1] + v[g.v2] + v[g.v3])[axis] * (1.0f / 3.0f);
        });
        stack[top++] = {RIGHT(r.node), mid, r.end, r.depth + 1};
        stack[top++] = {LEFT(r.node), r.begin, mid, r.depth + 1};
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection result;
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    if (nodes.empty())
        return result;
    IntersectionRay shrinking = ray;
    std::vector<size_t> stack;
    stack.reserve(64);
    stack.push_back(0);
    while (!stack.empty()) {
        const size_t i = stack.back();
        stack.pop_back();
        if (!intersect(nodes[i].bounds, shrinking))
            continue;
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd != 0) {
            stack.push_back(2 * i + 2);
            stack.push_back(2 * i + 1);
        } else {
            for (uint32_t face : bvh.getFaceIndices(nodes[i]))
                if (const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), shrinking)) {
                    result = hit;
                    shrinking.t_max = hit.t;
                }
        }
    }
    return result;
}
