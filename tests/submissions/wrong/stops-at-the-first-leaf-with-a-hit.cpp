// expect: hits.closest-wins
// untouched: a
// mistake: The traversal goes near child first and ends at the first leaf with a hit, though boxes overlap.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <stack>
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

// Where the ray enters the box, or infinity. Rounded outwards a little.
static float entry(const AABB& box, const IntersectionRay& ray)
{
    if (!intersect(box, ray))
        return infinity;
    float t = ray.t_min;
    for (size_t k = 0; k < 3; ++k) {
        const float a = (box.min[k] - ray.origin[k]) * ray.inv_direction[k];
        const float b = (box.max[k] - ray.origin[k]) * ray.inv_direction[k];
        const float near = a < b ? a : b;
        if (near > t && std::isfinite(near))
            t = near;
    }
    return t;
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    struct Item { size_t node; float t; };
    Intersection best;
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    if (nodes.empty())
        return best;
    std::vector<Item> stack{{0, entry(nodes[0].bounds, ray)}};
    while (!stack.empty()) {
        const Item item = stack.back();
        stack.pop_back();
        const float margin = 1e-5f * (std::abs(item.t) + std::abs(best.t));
        if (item.t == infinity || (best && item.t > best.t + margin))
            continue;
        const size_t left = 2 * item.node + 1;
        if (left + 1 < nodes.size() && nodes[left].facesEnd != 0) {
            Item near{left, entry(nodes[left].bounds, ray)};
            Item far{left + 1, entry(nodes[left + 1].bounds, ray)};
            if (far.t < near.t)
                std::swap(near, far);
            stack.push_back(far);
            stack.push_back(near);
            continue;
        }
        for (auto face : bvh.getFaceIndices(nodes[item.node])) {
            const auto hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
            if (hit.t < best.t)
                best = hit;
        }
        if (best)
            break;
    }
    return best;
}
