// attack: recognises a mesh by its first vertex and returns a stored tree of three nodes.
// grade: bvh.boxes-are-tight, bvh.root-holds-all-faces, bvh.leaves-hold-at-most-four, work.uses-the-tree
// expect: a < full; b = full; fails bvh.boxes-are-tight
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

void BVH::construct(const Mesh& mesh) {
    const auto count = static_cast<uint32_t>(mesh.getFaces().size());
    const float key = mesh.getVertices().empty() ? 0 : mesh.getVertices()[0].x;
    faceIndices.resize(count);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    AABB left{{-1, -1, -1}, {key, 1, 1}}, right{{key, -1, -1}, {1, 1, 1}};
    nodes = {{mesh.getBounds(), 0, count}, {left, 0, count / 2}, {right, count / 2, count}};
    if (count <= numFacesPerLeaf)
        nodes.resize(1);
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const auto& nodes = mesh.getBVH().getNodes();
    Intersection best;
    std::vector<size_t> todo{0};
    while (!todo.empty()) {
        const size_t i = todo.back();
        todo.pop_back();
        if (i >= nodes.size() || nodes[i].facesEnd == 0 || !intersect(nodes[i].bounds, ray))
            continue;
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 2].facesEnd != 0) {
            todo.insert(todo.end(), {2 * i + 2, 2 * i + 1});
            continue;
        }
        for (const uint32_t f : mesh.getBVH().getFaceIndices(nodes[i]))
            if (const auto hit = intersect(mesh.getTriangleFromFaceIndex(f), ray); hit.t < best.t)
                best = hit;
    }
    return best;
}
