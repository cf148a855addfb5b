// expect: source.construct-loops
// untouched: b
// mistake: A guard splits a node when it is destroyed, and makes guards of both children for that.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <algorithm>
#include <functional>
#include <numeric>
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
    struct Guard {
        const std::function<void(size_t)>& work;
        size_t index;
        ~Guard() { work(index); }
    };
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
        Guard second{split, 2 * index + 2};
        Guard first{split, 2 * index + 1};
    };
    Guard root{split, 0};
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection closest;
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    if (nodes.empty())
        return closest;

    std::stack<size_t> todo;
    todo.push(0);
    while (!todo.empty()) {
        const size_t index = todo.top();
        todo.pop();
        if (!intersect(nodes[index].bounds, ray))
            continue;
        const size_t left = 2 * index + 1;
        const size_t right = left + 1;
        if (right < nodes.size() && nodes[left].facesEnd != 0 && nodes[right].facesEnd != 0) {
            todo.push(right);
            todo.push(left);
            continue;
        }
        for (uint32_t face : bvh.getFaceIndices(nodes[index])) {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
            if (hit.t < closest.t)
                closest = hit;
        }
    }
    return closest;
}
