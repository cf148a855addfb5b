// right: free helpers named construct and intersect, "construct(mesh)" in comments and strings; nothing of it recurses
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "triangle.h"

#include <iostream>

// Builds one node. (Not recursive: construct(mesh) calls this once per child.)
BVH::Node construct(const Mesh& mesh, std::span<const uint32_t> faces, uint32_t begin)
{
    BVH::Node node;
    node.facesBegin = begin;
    node.facesEnd = begin + static_cast<uint32_t>(faces.size());
    for (uint32_t face : faces) {
        const Triangle triangle = mesh.getTriangleFromFaceIndex(face);
        node.bounds.extend(triangle.v1);
        node.bounds.extend(triangle.v2);
        node.bounds.extend(triangle.v3);
    }
    return node;
}

/* void BVH::construct(const Mesh& mesh) { construct(mesh); } would be recursion */
void BVH::construct(const Mesh& mesh)
{
    const uint32_t numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes = {Node{mesh.getBounds(), 0, numFaces}};

    const size_t inner = (size_t{1} << maxDepth) - 1;
    for (size_t i = 0; i < std::min(nodes.size(), inner); ++i) {
        const Node node = nodes[i];
        const auto faces = getFaceIndices(node);
        if (faces.size() <= numFacesPerLeaf)
            continue;
        const auto axis = node.bounds.extents().maxDimension();
        const size_t half = (faces.size() + 1) / 2;
        std::nth_element(faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(half), faces.end(), [&](uint32_t a, uint32_t b) {
            const auto center = [&](uint32_t face) {
                const Triangle t = mesh.getTriangleFromFaceIndex(face);
                return (t.v1 + t.v2 + t.v3) * (1.f / 3.f);
            };
            return center(a)[axis] < center(b)[axis];
        });
        const Node left = ::construct(mesh, faces.first(half), node.facesBegin);
        const Node right = ::construct(mesh, faces.subspan(half), left.facesEnd);
        if (nodes.size() < 2 * i + 3)
            nodes.resize(2 * i + 3);
        nodes[2 * i + 1] = left;
        nodes[2 * i + 2] = right;
    }
    std::cout << "construct(mesh); done, BVH::construct(mesh) made " << nodes.size() << " nodes\n";
}

// The faces of one leaf.
Intersection intersect(const Mesh& mesh, const BVH::Node& leaf, const IntersectionRay& ray)
{
    Intersection best;
    for (uint32_t face : mesh.getBVH().getFaceIndices(leaf)) {
        const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
        if (hit.t < best.t)
            best = hit;
    }
    return best;
}

// One subtree.
Intersection intersect(const Mesh& mesh, size_t index, const IntersectionRay& ray)
{
    const auto& nodes = mesh.getBVH().getNodes();
    if (index >= nodes.size() || nodes[index].facesEnd == 0 || !intersect(nodes[index].bounds, ray))
        return {};
    const size_t left = 2 * index + 1, right = 2 * index + 2;
    if (right >= nodes.size() || nodes[left].facesEnd == 0 || nodes[right].facesEnd == 0)
        return intersect(mesh, nodes[index], ray);
    const Intersection a = intersect(mesh, left, ray);
    const Intersection b = intersect(mesh, right, ray);
    return a.t <= b.t ? a : b;
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    return intersect(mesh, size_t{0}, ray);
}
