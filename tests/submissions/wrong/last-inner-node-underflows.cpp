// expect: bvh.survives-every-mesh, bvh.memory-is-safe
// untouched: b
// mistake: The index of the last inner node is computed as unsigned (size - 3) / 2, which wraps around when there is only the root.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <queue>

void BVH::construct(const Mesh& mesh)
{
    const uint32_t numFaces = uint32_t(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);

    nodes.clear();
    nodes.resize(2 * roundUpPowerOfTwo((numFaces + numFacesPerLeaf - 1) / numFacesPerLeaf) - 1);
    if (nodes.size() > (2u << maxDepth) - 1)
        nodes.resize((2u << maxDepth) - 1);
    nodes[0] = Node{mesh.getBounds(), 0, numFaces};

    const uint32_t lastInner = (uint32_t(nodes.size()) - 3) / 2;
    for (uint32_t i = 0; i <= lastInner; ++i) {
        const Node node = nodes[i];
        if (node.facesEnd - node.facesBegin <= numFacesPerLeaf)
            continue;
        const auto faces = getFaceIndices(node);
        const auto axis = node.bounds.extents().maxDimension();
        const auto half = faces.size() / 2;
        auto key = [&](uint32_t f) { const auto t = mesh.getTriangleFromFaceIndex(f); return ((t.v1 + t.v2 + t.v3) / 3)[axis]; };
        std::nth_element(faces.begin(), faces.begin() + half, faces.end(), [&](auto a, auto b) { return key(a) < key(b); });
        nodes[2 * i + 1] = Node{AABB{}, node.facesBegin, node.facesBegin + uint32_t(half)};
        nodes[2 * i + 2] = Node{AABB{}, node.facesBegin + uint32_t(half), node.facesEnd};
        for (size_t k = 0; k < faces.size(); ++k) {
            const auto t = mesh.getTriangleFromFaceIndex(faces[k]);
            AABB& box = nodes[k < half ? 2 * i + 1 : 2 * i + 2].bounds;
            box.extend(t.v1); box.extend(t.v2); box.extend(t.v3);
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
