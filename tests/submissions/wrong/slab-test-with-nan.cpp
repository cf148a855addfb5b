// expect: hits.special-rays
// untouched: a
// mistake: 0 * inf makes a NaN in the own box test, so rays in the plane of a side are lost.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

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

static bool hitsBox(const AABB& box, const IntersectionRay& ray, float closest)
{
    float enter = ray.t_min;
    float leave = std::min(ray.t_max, closest);
    for (int axis = 0; axis < 3; ++axis) {
        float t0 = (box.min[axis] - ray.origin[axis]) * ray.inv_direction[axis];
        float t1 = (box.max[axis] - ray.origin[axis]) * ray.inv_direction[axis];
        if (t0 > t1)
            std::swap(t0, t1);
        // a little slack against rounding
        enter = std::max(t0 - 1e-6f * std::abs(t0), enter);
        leave = std::min(t1 + 1e-6f * std::abs(t1), leave);
    }
    return enter <= leave;
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    const auto& nodes = mesh.getBVH().getNodes();
    if (nodes.empty())
        return best;
    std::vector<uint32_t> todo{0};
    while (!todo.empty()) {
        const uint32_t i = todo.back();
        todo.pop_back();
        if (!hitsBox(nodes[i].bounds, ray, best.t + 1e-5f * std::abs(best.t)))
            continue;
        if (2 * i + 1 < nodes.size() && nodes[2 * i + 1].facesEnd != 0) {
            todo.push_back(2 * i + 2);
            todo.push_back(2 * i + 1);
        } else {
            for (uint32_t face : mesh.getBVH().getFaceIndices(nodes[i])) {
                const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
                if (hit.t < best.t)
                    best = hit;
            }
        }
    }
    return best;
}
