// expect: hits.closest-wins
// untouched: a
// mistake: The stack has room for twelve nodes, deeper trees lose some.
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
    const uint32_t numFaces = uint32_t(mesh.getFaces().size());
    std::vector<Point3D> center(numFaces);
    std::vector<AABB> box(numFaces);
    faceIndices.resize(numFaces);
    for (uint32_t f = 0; f < numFaces; ++f) {
        const Triangle t = mesh.getTriangleFromFaceIndex(f);
        center[f] = (t.v1 + t.v2 + t.v3) / 3.f;
        box[f].extend(t.v1);
        box[f].extend(t.v2);
        box[f].extend(t.v3);
        faceIndices[f] = f;
    }
    nodes.clear();
    nodes.push_back(Node{mesh.getBounds(), 0, numFaces});
    std::vector<uint32_t> todo{0};
    for (size_t done = 0; done < todo.size(); ++done) {
        const uint32_t i = todo[done];
        const Node node = nodes[i];
        const uint32_t count = node.facesEnd - node.facesBegin;
        if (count <= numFacesPerLeaf || i + 1 >= (1u << maxDepth))
            continue;
        const auto faces = getFaceIndices(node);
        const auto axis = node.bounds.extents().maxDimension();
        std::nth_element(faces.begin(), faces.begin() + count / 2, faces.end(),
                         [&](uint32_t a, uint32_t b) { return center[a][axis] < center[b][axis]; });
        if (nodes.size() < 2 * i + 3)
            nodes.resize(2 * i + 3);
        nodes[2 * i + 1] = Node{{}, node.facesBegin, node.facesBegin + count / 2};
        nodes[2 * i + 2] = Node{{}, node.facesBegin + count / 2, node.facesEnd};
        for (uint32_t child : {2 * i + 1, 2 * i + 2}) {
            for (uint32_t f : getFaceIndices(nodes[child]))
                nodes[child].bounds.extend(box[f]);
            todo.push_back(child);
        }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    const auto& baum = mesh.getBVH();
    const auto& knoten = baum.getNodes();
    Intersection naechster;  // t ist unendlich
    if (knoten.empty()) return naechster;

    uint32_t stapel[12];
    int hoehe = 0;
    stapel[hoehe++] = 0;
    while (hoehe > 0) {
        const uint32_t i = stapel[--hoehe];
        if (!intersect(knoten[i].bounds, ray)) continue;
        const uint32_t links = 2 * i + 1, rechts = 2 * i + 2;
        const bool blatt = rechts >= knoten.size() || knoten[links].facesEnd == 0 || knoten[rechts].facesEnd == 0;
        if (!blatt) {
            if (hoehe < 12) stapel[hoehe++] = links;
            if (hoehe < 12) stapel[hoehe++] = rechts;
        } else {
            for (auto f : baum.getFaceIndices(knoten[i])) {
                auto treffer = intersect(mesh.getTriangleFromFaceIndex(f), ray);
                if (treffer.t < naechster.t) naechster = treffer;
            }
        }
    }
    return naechster;
}
