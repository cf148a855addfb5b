// expect: bvh.rebuild-starts-afresh
// untouched: b
// mistake: The ranges are reset for a second mesh but not the boxes.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <queue>

void BVH::construct(const Mesh& mesh)
{
    const uint32_t numFaces = uint32_t(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);

    for (Node& node : nodes)
        node.facesBegin = node.facesEnd = 0;
    nodes.resize(2 * roundUpPowerOfTwo((numFaces + numFacesPerLeaf - 1) / numFacesPerLeaf) - 1);
    nodes[0] = Node{mesh.getBounds(), 0, numFaces};

    for (uint32_t depth = 0; depth < maxDepth; ++depth) {
        const uint32_t first = (1u << depth) - 1;
        for (uint32_t i = first; i <= 2 * first && 2 * i + 2 < nodes.size(); ++i) {
            const Node& node = nodes[i];
            if (node.facesEnd - node.facesBegin <= numFacesPerLeaf)
                continue;
            const auto faces = getFaceIndices(node);
            const auto axis = node.bounds.extents().maxDimension();
            const auto half = faces.size() / 2;
            auto key = [&](uint32_t f) { const auto t = mesh.getTriangleFromFaceIndex(f); return ((t.v1 + t.v2 + t.v3) / 3)[axis]; };
            std::nth_element(faces.begin(), faces.begin() + half, faces.end(), [&](auto a, auto b) { return key(a) < key(b); });

            Node& left = nodes[2 * i + 1];
            Node& right = nodes[2 * i + 2];
            left.facesBegin = node.facesBegin;
            left.facesEnd = right.facesBegin = node.facesBegin + uint32_t(half);
            right.facesEnd = node.facesEnd;
            for (size_t k = 0; k < faces.size(); ++k) {
                const auto t = mesh.getTriangleFromFaceIndex(faces[k]);
                AABB& box = k < half ? left.bounds : right.bounds;
                box.extend(t.v1); box.extend(t.v2); box.extend(t.v3);
            }
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
