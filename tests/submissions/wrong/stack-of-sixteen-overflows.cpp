// expect: hits.memory-is-safe
// untouched: a
// mistake: The stack has room for sixteen nodes, too few for the deepest tree.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <cmath>
#include <iostream>
#include <numeric>
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

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    const auto& baum = mesh.getBVH();
    const auto& knoten = baum.getNodes();
    Intersection naechster;  // t ist unendlich
    if (knoten.empty()) return naechster;

    uint32_t stapel[16];
    int hoehe = 0;
    stapel[hoehe++] = 0;
    while (hoehe > 0) {
        const uint32_t i = stapel[--hoehe];
        if (!intersect(knoten[i].bounds, ray)) continue;
        const uint32_t links = 2 * i + 1, rechts = 2 * i + 2;
        const bool blatt = rechts >= knoten.size() || knoten[links].facesEnd == 0 || knoten[rechts].facesEnd == 0;
        if (!blatt) {
            stapel[hoehe++] = links;
            stapel[hoehe++] = rechts;
        } else {
            for (auto f : baum.getFaceIndices(knoten[i])) {
                auto treffer = intersect(mesh.getTriangleFromFaceIndex(f), ray);
                if (treffer.t < naechster.t) naechster = treffer;
            }
        }
    }
    return naechster;
}
