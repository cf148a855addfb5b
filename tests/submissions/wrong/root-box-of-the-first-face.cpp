// expect: bvh.root-holds-all-faces
// untouched: b
// mistake: The box of the root covers only the first face.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <queue>

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
        for (size_t k = r.begin; k < (r.node == 0 ? r.begin + 1 : r.end); k++) {
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
