// right: the literals 4 and 20 instead of the constants, German comments, prints to std::cout, fixed array as stack
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "triangle.h"

#include <iostream>
#include <numeric>

// Schwerpunkt des Dreiecks (größer/kleiner genügt uns, daher float)
Point3D schwerpunkt(const Triangle& d) { return (d.v1 + d.v2 + d.v3) / 3; }

void BVH::construct(const Mesh& mesh)
{
    const uint32_t anzahl = mesh.getFaces().size();
    faceIndices = std::vector<uint32_t>(anzahl);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);
    nodes = { Node{mesh.getBounds(), 0, anzahl} };
    if (anzahl == 0) {
        std::cout << "leeres Netz" << std::endl;
        return;
    }

    // Ebene für Ebene: die Wurzel ist Tiefe 0
    for (int tiefe = 0; tiefe < 20; ++tiefe) {
        const size_t erster = (size_t(1) << tiefe) - 1;
        const size_t letzter = std::min(2 * erster + 1, nodes.size());
        bool geteilt = false;
        for (size_t i = erster; i < letzter; ++i) {
            const Node knoten = nodes[i];
            if (knoten.facesEnd - knoten.facesBegin <= 4)
                continue;
            geteilt = true;
            const int achse = knoten.bounds.extents().maxDimension();
            const uint32_t mitte = (knoten.facesBegin + knoten.facesEnd + 1) / 2;  // links eins mehr
            std::nth_element(faceIndices.data() + knoten.facesBegin, faceIndices.data() + mitte,
                             faceIndices.data() + knoten.facesEnd, [&mesh, achse](uint32_t a, uint32_t b) {
                                 return schwerpunkt(mesh.getTriangleFromFaceIndex(a))[achse]
                                      < schwerpunkt(mesh.getTriangleFromFaceIndex(b))[achse];
                             });
            if (nodes.size() <= 2 * i + 2)
                nodes.resize(2 * i + 3);
            nodes[2 * i + 1] = {{}, knoten.facesBegin, mitte};
            nodes[2 * i + 2] = {{}, mitte, knoten.facesEnd};
            for (size_t kind = 2 * i + 1; kind <= 2 * i + 2; ++kind)
                for (uint32_t f : getFaceIndices(nodes[kind])) {
                    const Triangle d = mesh.getTriangleFromFaceIndex(f);
                    for (const Point3D* ecke : {&d.v1, &d.v2, &d.v3})
                        nodes[kind].bounds.extend(*ecke);
                }
        }
        if (!geteilt)
            break;
    }
    std::cout << "BVH: " << nodes.size() << " Knoten für " << anzahl << " Dreiecke\n";
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    const auto& baum = mesh.getBVH();
    const auto& knoten = baum.getNodes();
    Intersection naechster;  // t ist unendlich
    if (knoten.empty()) return naechster;

    uint32_t stapel[64];
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
