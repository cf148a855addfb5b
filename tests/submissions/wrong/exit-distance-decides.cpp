// expect: hits.closest-wins
// untouched: a
// mistake: The heap is ordered by where the ray leaves the boxes, and ends at the first that ends behind the hit.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"

#include <cmath>
#include <functional>
#include <queue>

void BVH::construct(const Mesh& mesh)
{
    const uint32_t numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.clear();
    nodes.push_back(Node{mesh.getBounds(), 0, numFaces});

    // helpers as std::function; none of them calls itself
    const std::function<float(uint32_t, uint8_t)> center = [&mesh](uint32_t face, uint8_t axis) {
        const Triangle t = mesh.getTriangleFromFaceIndex(face);
        return (t.v1[axis] + t.v2[axis] + t.v3[axis]) / 3.0f;
    };
    const std::function<AABB(const Node&)> bounds = [&](const Node& node) {
        AABB box;
        for (uint32_t face : getFaceIndices(node)) {
            const Triangle t = mesh.getTriangleFromFaceIndex(face);
            box.extend(t.v1);
            box.extend(t.v2);
            box.extend(t.v3);
        }
        return box;
    };

    uint32_t current = 0;
    while (current < nodes.size()) {
        const uint32_t depth = std::bit_width(current + 1) - 1u;
        const Node node = nodes[current];
        const uint32_t count = node.facesEnd - node.facesBegin;
        if (count > numFacesPerLeaf && depth < maxDepth) {
            const uint8_t axis = node.bounds.extents().maxDimension();
            const uint32_t middle = node.facesBegin + count / 2;
            std::nth_element(faceIndices.begin() + node.facesBegin, faceIndices.begin() + middle, faceIndices.begin() + node.facesEnd,
                             [&](uint32_t a, uint32_t b) { return center(a, axis) < center(b, axis); });
            Node left{{}, node.facesBegin, middle};
            Node right{{}, middle, node.facesEnd};
            left.bounds = bounds(left);
            right.bounds = bounds(right);
            if (nodes.size() < 2 * current + 3)
                nodes.resize(2 * current + 3);
            nodes[2 * current + 1] = left;
            nodes[2 * current + 2] = right;
        }
        ++current;
    }
}

namespace {
struct Candidate {
    float distance;
    size_t node;
    bool operator>(const Candidate& other) const { return distance > other.distance; }
};

float entryDistance(const AABB& box, const IntersectionRay& ray)
{
    float leave = infinity;
    for (size_t axis = 0; axis < 3; ++axis) {
        if (ray.direction[axis] == 0.f)
            continue;
        const float plane = ray.direction[axis] > 0.f ? box.max[axis] : box.min[axis];
        leave = std::fmin(leave, (plane - ray.origin[axis]) * ray.inv_direction[axis]);
    }
    return leave - 1e-5f * std::fabs(leave);
}
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    const auto& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> open;
    const auto consider = [&](size_t i) {
        if (i < nodes.size() && intersect(nodes[i].bounds, ray))
            open.push({entryDistance(nodes[i].bounds, ray), i});
    };
    consider(0);
    while (!open.empty() && open.top().distance <= best.t) {
        const size_t i = open.top().node;
        open.pop();
        if (2 * i + 1 < nodes.size() && nodes[2 * i + 1].facesEnd != 0) {
            consider(2 * i + 1);
            consider(2 * i + 2);
            continue;
        }
        for (uint32_t face : bvh.getFaceIndices(nodes[i]))
            if (const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray); hit.t < best.t)
                best = hit;
    }
    return best;
}
