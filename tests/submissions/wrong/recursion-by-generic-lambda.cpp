// expect: source.construct-loops
// untouched: b
// mistake: A generic lambda gets itself as an argument and calls itself.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <algorithm>
#include <numeric>
#include <queue>
#include <stack>

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

void BVH::construct(const Mesh& mesh)
{
    const uint32_t n = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(n);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.assign(1, Node{mesh.getBounds(), 0, n});
    auto& faces = faceIndices;
    const auto subdivide = [&](const auto& self, size_t i, uint32_t depth) -> void {
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
        self(self, 2 * i + 1, depth + 1);
        self(self, 2 * i + 2, depth + 1);
    };
    subdivide(subdivide, 0, 0);
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
