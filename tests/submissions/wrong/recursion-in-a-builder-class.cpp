// expect: source.construct-loops
// untouched: b
// mistake: A builder class has a member function that calls itself.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <bit>

static BVH::Node makeNode(const Mesh& mesh, const std::vector<uint32_t>& faces, uint32_t begin, uint32_t end)
{
    BVH::Node node{AABB{}, begin, end};
    for (uint32_t k = begin; k < end; ++k) {
        const Triangle t = mesh.getTriangleFromFaceIndex(faces[k]);
        node.bounds.extend(t.v1);
        node.bounds.extend(t.v2);
        node.bounds.extend(t.v3);
    }
    return node;
}

class Builder
{
  public:
    Builder(const Mesh& m, std::vector<BVH::Node>& n, std::vector<uint32_t>& f) : mesh(m), nodes(n), faces(f) {}

    void build(size_t i, uint32_t depth)
    {
        const BVH::Node node = nodes[i];
        if (node.facesEnd - node.facesBegin <= BVH::numFacesPerLeaf || depth >= BVH::maxDepth)
            return;
        const uint32_t middle = (node.facesBegin + node.facesEnd) / 2;
        const uint8_t axis = node.bounds.extents().maxDimension();
        const auto center = [&](uint32_t face) {
            const Triangle t = mesh.getTriangleFromFaceIndex(face);
            return (t.v1[axis] + t.v2[axis] + t.v3[axis]) / 3.f;
        };
        std::nth_element(faces.begin() + node.facesBegin, faces.begin() + middle, faces.begin() + node.facesEnd,
                         [&](uint32_t a, uint32_t b) { return center(a) < center(b); });
        if (nodes.size() < 2 * i + 3)
            nodes.resize(2 * i + 3);
        nodes[2 * i + 1] = makeNode(mesh, faces, node.facesBegin, middle);
        nodes[2 * i + 2] = makeNode(mesh, faces, middle, node.facesEnd);
        build(2 * i + 1, depth + 1);
        build(2 * i + 2, depth + 1);
    }

  private:
    const Mesh& mesh;
    std::vector<BVH::Node>& nodes;
    std::vector<uint32_t>& faces;
};

void BVH::construct(const Mesh& mesh)
{
    const uint32_t n = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(n);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.assign(1, Node{mesh.getBounds(), 0, n});
    Builder(mesh, nodes, faceIndices).build(0, 0);
}

static void visit(const Mesh& mesh, const IntersectionRay& ray, size_t index, Intersection& best)
{
    const auto& nodes = mesh.getBVH().getNodes();
    if (!intersect(nodes[index].bounds, ray))
        return;
    if (2 * index + 1 >= nodes.size() || nodes[2 * index + 1].facesEnd == 0) {
        for (uint32_t f : mesh.getBVH().getFaceIndices(nodes[index])) {
            Intersection hit = intersect(mesh.getTriangleFromFaceIndex(f), ray);
            if (hit.t < best.t)
                best = hit;
        }
        return;
    }
    visit(mesh, ray, 2 * index + 1, best);
    visit(mesh, ray, 2 * index + 2, best);
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    if (!mesh.getBVH().getNodes().empty())
        visit(mesh, ray, 0, best);
    return best;
}
