// expect: hits.special-rays
// untouched: a
// mistake: The last answer is given again for the same origin and direction, whatever t_min and t_max are.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <algorithm>
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

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    thread_local const Mesh* lastMesh = nullptr;
    thread_local Ray lastRay;
    thread_local Intersection closest;
    if (lastMesh == &mesh && lastRay.origin == ray.origin && lastRay.direction == ray.direction)
        return closest;
    lastMesh = &mesh;
    lastRay = ray;
    closest = {};
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
