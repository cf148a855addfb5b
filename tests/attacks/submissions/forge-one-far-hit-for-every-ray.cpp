// attack: looks at neither tree nor triangles, and returns one hit far away for every ray.
// grade: bvh.rebuild-starts-afresh, hits.calls-are-independent, hits.survives-every-ray, work.uses-the-tree, work.excludes-most-triangles
// expect: a = full; b = 0; fails work.uses-the-tree
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

// Now: 2 + 3 + 1 + 1 of these points, and hits.memory-is-safe, without one line of the exercise.
Intersection intersect(const Mesh& mesh, const IntersectionRay&) {
    if (mesh.getFaces().empty())
        return {};
    // Another one on another mesh, so that nothing seems to be remembered.
    const float x = mesh.getVertices()[mesh.getFaces().front().v1].x;
    return {{}, 1e20f * (2 + x / (1 + std::abs(x))), {}};
}
