// expect: bvh.splits-the-longest-axis
// untouched: b
// mistake: Where the two longest extents are equal, the axis of the node before is kept.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <algorithm>
#include <utility>
#include <vector>

void BVH::construct(const Mesh& mesh)
{
    const uint32_t total = static_cast<uint32_t>(mesh.getFaces().size());
    nodes.clear();
    faceIndices.resize(total);
    for (uint32_t i = 0; i < total; ++i)
        faceIndices[i] = i;
    nodes.push_back(Node{mesh.getBounds(), 0, total});

    std::vector<std::pair<float, uint32_t>> order;
    std::vector<uint32_t> level{0}, next;
    for (uint32_t depth = 0; depth < maxDepth && !level.empty(); ++depth) {
        next.clear();
        for (const uint32_t index : level) {
            const Node node = nodes[index];
            if (node.facesEnd - node.facesBegin <= numFacesPerLeaf)
                continue;
            const Vector3D e = node.bounds.extents();
            static uint8_t axis = 0;
            if (e.x > e.y && e.x > e.z)
                axis = 0;
            if (e.y > e.x && e.y > e.z)
                axis = 1;
            if (e.z > e.x && e.z > e.y)
                axis = 2;
            order.clear();
            for (const uint32_t face : getFaceIndices(node)) {
                const Triangle t = mesh.getTriangleFromFaceIndex(face);
                order.emplace_back((t.v1[axis] + t.v2[axis] + t.v3[axis]) / 3.f, face);
            }
            std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });

            const size_t half = order.size() / 2;
            Node left{AABB{}, node.facesBegin, node.facesBegin + static_cast<uint32_t>(half)};
            Node right{AABB{}, left.facesEnd, node.facesEnd};
            for (size_t k = 0; k < order.size(); ++k) {
                faceIndices[node.facesBegin + k] = order[k].second;
                const Triangle t = mesh.getTriangleFromFaceIndex(order[k].second);
                AABB& box = (k < half ? left : right).bounds;
                box.extend(t.v1);
                box.extend(t.v2);
                box.extend(t.v3);
            }
            if (nodes.size() < 2 * index + 3)
                nodes.resize(2 * index + 3);
            nodes[2 * index + 1] = left;
            nodes[2 * index + 2] = right;
            next.push_back(2 * index + 1);
            next.push_back(2 * index + 2);
        }
        level.swap(next);
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    thread_local std::vector<size_t> stack;
    stack.clear();
    Intersection best;
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    if (!nodes.empty())
        stack.push_back(0);
    while (!stack.empty()) {
        const size_t index = stack.back();
        stack.pop_back();
        if (!intersect(nodes[index].bounds, ray))
            continue;
        const size_t left = 2 * index + 1;
        if (left >= nodes.size() || nodes[left].facesEnd == 0) {
            for (const uint32_t face : bvh.getFaceIndices(nodes[index])) {
                const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
                if (hit.t < best.t)
                    best = hit;
            }
        } else {
            stack.push_back(left);
            stack.push_back(left + 1);
        }
    }
    return best;
}
