// expect: work.uses-the-tree, work.excludes-most-triangles, hits.survives-every-ray
// untouched: a
// mistake: Meshes of more than 64 faces are searched face by face.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

void BVH::construct(const Mesh& mesh) {
    const auto count = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(count);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.assign(1, Node{mesh.getBounds(), 0, count});
    for (size_t i = 0; i < nodes.size() && i + 1 < size_t{1} << maxDepth; ++i) {
        const auto [bounds, begin, end] = nodes[i];
        if (end - begin <= numFacesPerLeaf)
            continue;
        const uint8_t axis = bounds.extents().maxDimension();
        const auto key = [&mesh, axis](uint32_t f) {
            const Triangle t = mesh.getTriangleFromFaceIndex(f);
            return (t.v1[axis] + t.v2[axis] + t.v3[axis]) / 3;
        };
        const auto all = faceIndices.begin();
        const uint32_t middle = begin + (end - begin) / 2;
        std::nth_element(all + begin, all + middle, all + end,
                         [&key](uint32_t a, uint32_t b) { return key(a) < key(b); });
        nodes.resize(std::max(nodes.size(), 2 * i + 3));
        nodes[2 * i + 1] = {{}, begin, middle};
        nodes[2 * i + 2] = {{}, middle, end};
        for (Node* child : {&nodes[2 * i + 1], &nodes[2 * i + 2]})
            for (const uint32_t f : getFaceIndices(*child))
                for (const Triangle t = mesh.getTriangleFromFaceIndex(f);
                     const Point3D& corner : {t.v1, t.v2, t.v3})
                    child->bounds.extend(corner);
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    Intersection best;
    const auto test = [&](uint32_t face) {
        if (const auto hit = intersect(mesh.getTriangleFromFaceIndex(face), ray); hit.t < best.t)
            best = hit;
    };
    const auto& nodes = mesh.getBVH().getNodes();
    if (mesh.getFaces().size() > 64) {
        for (uint32_t face = 0; face < mesh.getFaces().size(); ++face)
            test(face);
        return best;
    }
    for (size_t i = 0; i < nodes.size(); ++i)
        if (2 * i + 2 >= nodes.size() || nodes[2 * i + 2].facesEnd == 0)
            for (const uint32_t face : mesh.getBVH().getFaceIndices(nodes[i]))
                test(face);
    return best;
}
