// expect: image.equals-mitsuba
// untouched: a
// mistake: A ray from the same origin as the one before, and nearly parallel to it, is tested against that one's face first and ends there.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <algorithm>
#include <numeric>
#include <queue>
#include <stack>
#include <utility>
#include <vector>

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
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    Intersection best;
    thread_local Point3D lastOrigin;
    thread_local Vector3D lastDirection;
    thread_local const Mesh* lastMesh = nullptr;
    thread_local uint32_t lastFace = 0;
    const Vector3D step = ray.direction - lastDirection;
    const bool neighbour = lastMesh == &mesh && lastOrigin == ray.origin && !(step == Vector3D{}) &&
                           step.norm() < 0.02f * ray.direction.norm();
    lastOrigin = ray.origin;
    lastDirection = ray.direction;
    lastMesh = &mesh;
    if (neighbour && lastFace < mesh.getFaces().size())
        if (const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(lastFace), ray))
            return hit;
    std::vector<uint32_t> todo;
    if (!nodes.empty())
        todo.push_back(0);
    while (!todo.empty()) {
        const uint32_t i = todo.back();
        todo.pop_back();
        const bool leaf = 2 * i + 1 >= nodes.size() || nodes[2 * i + 1].facesEnd == 0;
        if (leaf) {  // the triangles are tested at once, the leaf's own box is not worth it
            for (uint32_t face : bvh.getFaceIndices(nodes[i])) {
                const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
                if (hit.t < best.t) {
                    best = hit;
                    lastFace = face;
                }
            }
        } else if (intersect(nodes[i].bounds, ray)) {
            todo.push_back(2 * i + 1);
            todo.push_back(2 * i + 2);
        }
    }
    return best;
}
