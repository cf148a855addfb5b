// expect: bvh.rebuild-starts-afresh
// untouched: b
// mistake: A mesh that fits into one leaf is put into the old root, whose old children stay.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <queue>

void BVH::construct(const Mesh& mesh)
{
    const uint32_t numFaces = uint32_t(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);

    if (nodes.empty())
        nodes.resize(1);
    nodes[0] = Node{mesh.getBounds(), 0, numFaces};
    if (numFaces != 0 && numFaces <= numFacesPerLeaf)
        return; // nothing to split
    nodes.clear();
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
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    std::vector<size_t> stack;
    Intersection best;
    if (!nodes.empty())
        stack.push_back(0);
    while (!stack.empty()) {
        const size_t i = stack.back();
        stack.pop_back();
        if (!intersect(nodes[i].bounds, ray))
            continue;
        const size_t left = 2 * i + 1, right = 2 * i + 2;
        if (right < nodes.size() && nodes[left].facesEnd != 0) {
            stack.push_back(right);
            stack.push_back(left);
            continue;
        }
        for (uint32_t face : bvh.getFaceIndices(nodes[i])) {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
            if (hit.t < best.t)
                best = hit;
        }
    }
    return best;
}
