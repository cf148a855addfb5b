// right: a hook chosen at compile time: a template parameter that may be a null function pointer, asked for by `if constexpr`
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

using Hook = void (*)(size_t node, uint32_t faces);

struct Splits {
    static inline thread_local uint32_t count = 0;
    static void one(size_t, uint32_t) { ++count; }
};

namespace {

template <Hook OnSplit = nullptr> struct Builder {
    const Mesh& mesh;
    std::vector<BVH::Node>& nodes;
    std::vector<uint32_t>& order;

    float centre(uint32_t face, size_t axis) const {
        const Triangle t = mesh.getTriangleFromFaceIndex(face);
        return (t.v1[axis] + t.v2[axis] + t.v3[axis]) / 3.0f;
    }

    BVH::Node leaf(uint32_t begin, uint32_t end) const {
        BVH::Node node{AABB{}, begin, end};
        for (uint32_t k = begin; k < end; ++k) {
            const Triangle t = mesh.getTriangleFromFaceIndex(order[k]);
            node.bounds.extend(t.v1);
            node.bounds.extend(t.v2);
            node.bounds.extend(t.v3);
        }
        return node;
    }

    void run() {
        for (size_t i = 0; i < nodes.size() && std::bit_width(i + 1) <= BVH::maxDepth; ++i) {
            const BVH::Node node = nodes[i];
            const uint32_t count = node.facesEnd - node.facesBegin;
            if (count <= BVH::numFacesPerLeaf)
                continue;
            if constexpr (OnSplit != nullptr)
                OnSplit(i, count);
            const uint32_t middle = node.facesBegin + count / 2;
            const size_t axis = node.bounds.extents().maxDimension();
            std::nth_element(order.begin() + node.facesBegin, order.begin() + middle, order.begin() + node.facesEnd,
                             [&](uint32_t a, uint32_t b) { return centre(a, axis) < centre(b, axis); });
            nodes.resize(std::max(nodes.size(), 2 * i + 3));
            nodes[2 * i + 1] = leaf(node.facesBegin, middle);
            nodes[2 * i + 2] = leaf(middle, node.facesEnd);
        }
    }
};

} // namespace

void BVH::construct(const Mesh& mesh) {
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.assign(1, Node{mesh.getBounds(), 0, numFaces});
    Splits::count = 0;
    Builder<Splits::one>{mesh, nodes, faceIndices}.run();
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const auto& nodes = mesh.getBVH().getNodes();
    Intersection best;
    std::vector<size_t> open;
    if (!nodes.empty())
        open.push_back(0);
    while (!open.empty()) {
        const size_t i = open.back();
        open.pop_back();
        if (!intersect(nodes[i].bounds, ray))
            continue;
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd != 0) {
            open.push_back(2 * i + 2);
            open.push_back(2 * i + 1);
            continue;
        }
        for (const uint32_t face : mesh.getBVH().getFaceIndices(nodes[i]))
            if (const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray); hit.t < best.t)
                best = hit;
    }
    return best;
}
