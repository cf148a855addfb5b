// expect: hits.closest-wins
// untouched: a
// mistake: The stack has room for 20 nodes, but a tree of depth 20 needs one more; the limit is a literal.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <queue>

void BVH::construct(const Mesh& mesh)
{
    const uint32_t numFaces = uint32_t(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);

    nodes.clear();
    nodes.resize(2 * roundUpPowerOfTwo((numFaces + numFacesPerLeaf - 1) / numFacesPerLeaf) - 1);
    nodes[0] = Node{mesh.getBounds(), 0, numFaces};

    for (uint32_t depth = 0; depth < 20; ++depth) {
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
    std::array<size_t, 20> stack;
    size_t size = 0;
    Intersection best;
    if (!nodes.empty())
        stack[size++] = 0;
    while (size > 0) {
        const size_t i = stack[--size];
        if (!intersect(nodes[i].bounds, ray))
            continue;
        const size_t left = 2 * i + 1, right = 2 * i + 2;
        if (right < nodes.size() && nodes[left].facesEnd != 0) {
            if (size < stack.size())
                stack[size++] = right;
            if (size < stack.size())
                stack[size++] = left;
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
