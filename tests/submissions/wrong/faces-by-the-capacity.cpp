// expect: bvh.is-readable
// untouched: b
// mistake: The faces are counted by getFaces().capacity(), which is larger than their number.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

void BVH::construct(const Mesh& mesh)
{
    const uint32_t n = uint32_t(mesh.getFaces().capacity());
    *this = {};
    faceIndices.resize(n);
    for (uint32_t i = 0; i < n; ++i)
        faceIndices[i] = i;
    nodes.push_back({mesh.getBounds(), 0, n});

    const size_t firstOfLastLevel = (size_t(1) << maxDepth) - 1;
    for (size_t i = 0; i < nodes.size() && i < firstOfLastLevel; ++i) {
        const uint32_t begin = nodes[i].facesBegin;
        const uint32_t end = nodes[i].facesEnd;
        if (end - begin <= numFacesPerLeaf)
            continue;
        const uint8_t axis = nodes[i].bounds.extents().maxDimension();
        const auto center = [&](uint32_t f) {
            const Triangle t = mesh.getTriangleFromFaceIndex(f);
            return (t.v1[axis] + t.v2[axis] + t.v3[axis]) * (1.f / 3.f);
        };
        const uint32_t mid = (begin + end) / 2;
        std::nth_element(faceIndices.begin() + begin, faceIndices.begin() + mid, faceIndices.begin() + end,
                         [&](uint32_t a, uint32_t b) { return center(a) < center(b); });
        const auto boxOf = [&](uint32_t from, uint32_t to) {
            AABB box;
            for (uint32_t k = from; k < to; ++k) {
                const Triangle t = mesh.getTriangleFromFaceIndex(faceIndices[k]);
                box.min = min(box.min, min(t.v1, min(t.v2, t.v3)));
                box.max = max(box.max, max(t.v1, max(t.v2, t.v3)));
            }
            return box;
        };
        nodes.resize(std::max(nodes.size(), 2 * i + 3));
        nodes[2 * i + 1] = Node{boxOf(begin, mid), begin, mid};
        nodes[2 * i + 2] = Node{boxOf(mid, end), mid, end};
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    const BVH& bvh = mesh.getBVH();
    const std::vector<BVH::Node>& nodes = bvh.getNodes();
    if (!bvh.isConstructed())
        return best;

    size_t i = 0;
    for (;;) {
        const BVH::Node& node = nodes[i];
        if (intersect(node.bounds, ray)) {
            if (2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd > 0) {
                i = 2 * i + 1;
                continue;
            }
            for (const uint32_t face : bvh.getFaceIndices(node)) {
                const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
                if (hit && hit.t < best.t)
                    best = hit;
            }
        }
        while (i > 0 && i % 2 == 0)  // a right child: its parent is done as well
            i = (i - 1) / 2;
        if (i == 0)
            return best;
        ++i;  // the right sibling
    }
}
