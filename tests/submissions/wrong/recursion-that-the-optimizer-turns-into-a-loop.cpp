// expect: source.construct-loops
// untouched: b
// mistake: The nodes are subdivided by a function that calls itself at its end.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

namespace {

using Nodes = std::vector<BVH::Node>;

__attribute__((noinline)) void split(Nodes& nodes, std::vector<uint32_t>& order, const Mesh& mesh, size_t i) {
    const auto [bounds, begin, end] = nodes[i];
    if (end - begin <= BVH::numFacesPerLeaf || i + 1 >= size_t{1} << BVH::maxDepth)
        return;
    const uint8_t axis = bounds.extents().maxDimension();
    const auto key = [&mesh, axis](uint32_t f) {
        const Triangle t = mesh.getTriangleFromFaceIndex(f);
        return (t.v1[axis] + t.v2[axis] + t.v3[axis]) / 3;
    };
    const auto all = order.begin();
    const uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(all + begin, all + middle, all + end,
                     [&key](uint32_t a, uint32_t b) { return key(a) < key(b); });
    nodes.resize(std::max(nodes.size(), 2 * i + 3));
    nodes[2 * i + 1] = {{}, begin, middle};
    nodes[2 * i + 2] = {{}, middle, end};
    for (BVH::Node* child : {&nodes[2 * i + 1], &nodes[2 * i + 2]})
        for (uint32_t k = child->facesBegin; k < child->facesEnd; ++k)
            for (const Triangle t = mesh.getTriangleFromFaceIndex(order[k]);
                 const Point3D& corner : {t.v1, t.v2, t.v3})
                child->bounds.extend(corner);
}

__attribute__((noinline, optimize("O2"))) void visit(Nodes& nodes, std::vector<uint32_t>& order, const Mesh& mesh, size_t i) {
    if (i >= nodes.size())
        return;
    split(nodes, order, mesh, i);
    visit(nodes, order, mesh, i + 1); // the recursion
}

} // namespace

void BVH::construct(const Mesh& mesh) {
    const auto count = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(count);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.assign(1, Node{mesh.getBounds(), 0, count});
    visit(nodes, faceIndices, mesh, 0);
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
