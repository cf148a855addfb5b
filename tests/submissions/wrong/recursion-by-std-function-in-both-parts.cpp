// expect: source.construct-loops
// untouched: b
// mistake: The nodes are subdivided by a std::function that calls itself, and another one in intersect has its signature.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <algorithm>
#include <functional>
#include <numeric>

Point3D triangleCenter(const Triangle& triangle)
{
    return (triangle.v1 + triangle.v2 + triangle.v3) / 3.0f;
}

void BVH::construct(const Mesh& mesh)
{
    const uint32_t numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.assign(1, Node{mesh.getBounds(), 0, numFaces});
    std::function<void(size_t)> split = [&](size_t index) {
        const Node node = nodes[index];
        const uint32_t depth = std::bit_width(index + 1) - 1;
        if (node.facesEnd - node.facesBegin <= numFacesPerLeaf || depth >= maxDepth)
            return;
        const uint8_t axis = node.bounds.extents().maxDimension();
        const uint32_t middle = node.facesBegin + (node.facesEnd - node.facesBegin) / 2;
        std::nth_element(faceIndices.begin() + node.facesBegin, faceIndices.begin() + middle,
                         faceIndices.begin() + node.facesEnd, [&](uint32_t a, uint32_t b) {
                             return triangleCenter(mesh.getTriangleFromFaceIndex(a))[axis] <
                                    triangleCenter(mesh.getTriangleFromFaceIndex(b))[axis];
                         });
        Node left{AABB{}, node.facesBegin, middle};
        Node right{AABB{}, middle, node.facesEnd};
        for (Node* child : {&left, &right})
            for (uint32_t face : getFaceIndices(*child)) {
                const Triangle triangle = mesh.getTriangleFromFaceIndex(face);
                child->bounds.extend(triangle.v1);
                child->bounds.extend(triangle.v2);
                child->bounds.extend(triangle.v3);
            }
        if (nodes.size() < 2 * index + 3)
            nodes.resize(2 * index + 3);
        nodes[2 * index + 1] = left;
        nodes[2 * index + 2] = right;
        split(2 * index + 1);
        split(2 * index + 2);
    };
    split(0);
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection closest;
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    if (nodes.empty())
        return closest;

    std::function<void(size_t)> visit = [&](size_t i) {
        if (!intersect(nodes[i].bounds, ray))
            return;
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd != 0) {
            visit(2 * i + 1);
            visit(2 * i + 2);
            return;
        }
        for (uint32_t face : bvh.getFaceIndices(nodes[i])) {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
            if (hit.t < closest.t)
                closest = hit;
        }
    };
    visit(0);
    return closest;
}
