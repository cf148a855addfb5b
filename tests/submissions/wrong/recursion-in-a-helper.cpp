// expect: source.construct-loops
// untouched: b
// mistake: The nodes are subdivided by a function that calls itself.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"


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

static void subdivide(const Mesh& mesh, std::vector<BVH::Node>& nodes, std::vector<uint32_t>& faces, size_t i, uint32_t depth)
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
    subdivide(mesh, nodes, faces, 2 * i + 1, depth + 1);
    subdivide(mesh, nodes, faces, 2 * i + 2, depth + 1);
}

void BVH::construct(const Mesh& mesh)
{
    const uint32_t n = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(n);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.assign(1, Node{mesh.getBounds(), 0, n});
    subdivide(mesh, nodes, faceIndices, 0, 0);
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    std::vector<size_t> current, next;
    if (!nodes.empty())
        current.push_back(0);
    for (; !current.empty(); current.swap(next), next.clear())  // level by level
        for (size_t i : current) {
            if (!intersect(nodes[i].bounds, ray))
                continue;
            if (2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd != 0) {
                next.push_back(2 * i + 1);
                next.push_back(2 * i + 2);
            } else
                for (uint32_t face : bvh.getFaceIndices(nodes[i])) {
                    const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
                    if (hit.t < best.t)
                        best = hit;
                }
        }
    return best;
}
