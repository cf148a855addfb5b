// expect: hits.memory-is-safe
// untouched: a
// mistake: A hash of the path, kept for debugging, overflows a signed int.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <queue>
#include <stack>

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

    struct Entry { uint32_t node; uint32_t depth; };
    std::queue<Entry> todo;
    todo.push({0, 0});
    while (!todo.empty()) {
        const Entry entry = todo.front();
        todo.pop();
        const Node node = nodes[entry.node];
        if (node.facesEnd - node.facesBegin <= numFacesPerLeaf || entry.depth >= maxDepth)
            continue;

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

        const uint32_t leftIndex = 2 * entry.node + 1;
        if (nodes.size() < leftIndex + 2)
            nodes.resize(leftIndex + 2);
        nodes[leftIndex] = left;
        nodes[leftIndex + 1] = right;
        todo.push({leftIndex, entry.depth + 1});
        todo.push({leftIndex + 1, entry.depth + 1});
    }
}

static thread_local int path = 1;

static void visit(const Mesh& mesh, const IntersectionRay& ray, size_t index, Intersection& best)
{
    path = path * 31 + static_cast<int>(index % 1000) + 1;
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
        path = 1, visit(mesh, ray, 0, best);
    return best;
}
