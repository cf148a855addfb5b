// expect: bvh.root-holds-all-faces, bvh.splits-the-longest-axis
// untouched: b
// mistake: The root never gets a box.
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
    nodes.push_back({AABB{}, 0, numFaces});

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

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    std::vector<size_t> current, next;
    if (!nodes.empty())
        current.push_back(0);
    for (; !current.empty(); current.swap(next), next.clear())  // level by level
        for (size_t i : current) {
            if (!intersect(nodes[i].bounds, ray))
                continue;
            if (2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd != 0) {
                next.push_back(2 * i + 1);
                next.push_back(2 * i + 2);
            } else
                for (uint32_t face : bvh.getFaceIndices(nodes[i])) {
                    const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
                    if (hit.t < best.t)
                        best = hit;
                }
        }
    return best;
}
