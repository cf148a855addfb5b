// expect: hits.special-rays
// untouched: a
// mistake: A ray with a finite t_max is taken for a shadow ray and ends at any hit.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <cmath>
#include <vector>

void BVH::construct(const Mesh& mesh)
{
    nodes.clear();
    faceIndices.clear();
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    if (numFaces == 0)
        return;
    for (uint32_t i = 0; i < numFaces; ++i)
        faceIndices.push_back(i);
    nodes.push_back({mesh.getBounds(), 0, numFaces});

    auto makeNode = [&](uint32_t begin, uint32_t end) {
        Node node{{}, begin, end};
        for (auto face : getFaceIndices(node)) {
            auto triangle = mesh.getTriangleFromFaceIndex(face);
            node.bounds.extend(triangle.v1);
            node.bounds.extend(triangle.v2);
            node.bounds.extend(triangle.v3);
        }
        return node;
    };

    size_t levelBegin = 0;
    for (uint32_t depth = 0; depth < maxDepth; ++depth) {
        const size_t levelEnd = nodes.size();
        bool split = false;
        for (size_t i = levelBegin; i < levelEnd; ++i) {
            const Node node = nodes[i];
            if (node.facesEnd - node.facesBegin <= numFacesPerLeaf) {
                nodes.push_back(Node{});
                nodes.push_back(Node{});
                continue;
            }
            split = true;
            const uint32_t mid = node.facesBegin + (node.facesEnd - node.facesBegin) / 2;
            const uint8_t axis = node.bounds.extents().maxDimension();
            auto faces = getFaceIndices(node);
            std::nth_element(faces.begin(), faces.begin() + (mid - node.facesBegin), faces.end(),
                             [&](uint32_t a, uint32_t b) {
                                 auto s = mesh.getTriangleFromFaceIndex(a);
                                 auto t = mesh.getTriangleFromFaceIndex(b);
                                 const auto sum = [](const Triangle& x) { return x.v1 + x.v2 + x.v3; };
                                 return sum(s)[axis] < sum(t)[axis];
                             });
            nodes.push_back(makeNode(node.facesBegin, mid));
            nodes.push_back(makeNode(mid, node.facesEnd));
        }
        levelBegin = levelEnd;
        if (!split)
            break;
    }
    while (nodes.back().facesEnd == 0)
        nodes.pop_back();
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
            if (hit && ray.t_max < infinity)
                return hit;
        }
    }
    return best;
}
