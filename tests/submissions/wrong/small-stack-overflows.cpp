// expect: hits.memory-is-safe
// untouched: a
// mistake: The stack has room for eight nodes and is written beyond its end.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <bit>
#include <iostream>
#include <numeric>

void BVH::construct(const Mesh& mesh)
{
    uint32_t numFaces = mesh.getFaces().size();
    faceIndices.clear();
    for (uint32_t i = 0; i != numFaces; i++)
        faceIndices.push_back(i);
    nodes.clear();
    nodes.push_back(Node{mesh.getBounds(), 0, numFaces});

    for (uint32_t i = 0; i < nodes.size(); i++) {
        Node node = nodes[i];
        uint32_t level = std::bit_width(i + 1);  // 1 for the root
        if (level >= maxDepth || node.facesEnd - node.facesBegin <= numFacesPerLeaf)
            continue;

        Vector3D size = node.bounds.extents();
        int axis = 0;
        if (size.y > size[axis]) axis = 1;
        if (size.z > size[axis]) axis = 2;

        std::span<uint32_t> faces = getFaceIndices(node);
        size_t half = faces.size() / 2;
        std::nth_element(faces.begin(), faces.begin() + half, faces.end(), [&](uint32_t a, uint32_t b) {
            Triangle s = mesh.getTriangleFromFaceIndex(a);
            Triangle t = mesh.getTriangleFromFaceIndex(b);
            return s.v1[axis] / 3 + s.v2[axis] / 3 + s.v3[axis] / 3 < t.v1[axis] / 3 + t.v2[axis] / 3 + t.v3[axis] / 3;
        });

        if (nodes.size() < 2 * i + 3)
            nodes.resize(2 * i + 3);
        for (int side = 0; side < 2; side++) {
            Node& child = nodes[2 * i + 1 + side];
            child.facesBegin = node.facesBegin + (side ? half : 0);
            child.facesEnd = side ? node.facesEnd : node.facesBegin + half;
            child.bounds = AABB();
            for (uint32_t f : getFaceIndices(child)) {
                Triangle t = mesh.getTriangleFromFaceIndex(f);
                child.bounds.extend(t.v1);
                child.bounds.extend(t.v2);
                child.bounds.extend(t.v3);
            }
        }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    const auto& baum = mesh.getBVH();
    const auto& knoten = baum.getNodes();
    Intersection naechster;  // t ist unendlich
    if (knoten.empty()) return naechster;

    uint32_t stapel[8];
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
