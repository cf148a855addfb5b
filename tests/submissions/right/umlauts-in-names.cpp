// right: Bezeichner mit Umlauten und griechischen Buchstaben (UTF-8), auch in den Namen von Funktionen und Klassen
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

namespace größen
{
    /// Der Schwerpunkt Σ/3 der Ecken
    Point3D schwerpunkt(const Triangle& Δ) { return (Δ.v1 + Δ.v2 + Δ.v3) / 3.0f; }

    /// Die Achse mit der größten Ausdehnung
    int längsteAchse(const AABB& würfel)
    {
        const Vector3D größe = würfel.max - würfel.min;
        return größe.x >= größe.y ? (größe.x >= größe.z ? 0 : 2) : (größe.y >= größe.z ? 1 : 2);
    }

    struct Hälften
    {
        std::span<uint32_t> kleinere, größere;
    };

    Hälften teileAmMedian(std::span<uint32_t> flächen, const Mesh& netz, int achse)
    {
        const size_t μ = flächen.size() / 2;
        std::nth_element(flächen.begin(), flächen.begin() + μ, flächen.end(), [&](uint32_t α, uint32_t β) {
            return schwerpunkt(netz.getTriangleFromFaceIndex(α))[achse] < schwerpunkt(netz.getTriangleFromFaceIndex(β))[achse];
        });
        return {flächen.first(μ), flächen.subspan(μ)};
    }

    AABB umhülle(std::span<uint32_t> flächen, const Mesh& netz)
    {
        AABB hülle;
        for (const uint32_t fläche : flächen)
        {
            const Triangle Δ = netz.getTriangleFromFaceIndex(fläche);
            hülle.extend(Δ.v1);
            hülle.extend(Δ.v2);
            hülle.extend(Δ.v3);
        }
        return hülle;
    }
}

void BVH::construct(const Mesh& mesh)
{
    using namespace größen;
    const uint32_t anzahl = static_cast<uint32_t>(mesh.getFaces().size());
    nodes.clear();
    faceIndices.resize(anzahl);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);
    nodes.push_back({mesh.getBounds(), 0, anzahl});

    std::cout << "Baue Hüllkörper für " << anzahl << " Flächen …\n";
    for (size_t i = 0; i < nodes.size(); ++i)
    {
        const Node knoten = nodes[i];
        const bool zuTief = i + 1 >= size_t(1) << maxDepth;
        if (knoten.facesEnd - knoten.facesBegin <= numFacesPerLeaf || zuTief)
            continue;
        const auto [kleinere, größere] = teileAmMedian(getFaceIndices(knoten), mesh, längsteAchse(knoten.bounds));
        const uint32_t mitte = knoten.facesBegin + static_cast<uint32_t>(kleinere.size());
        if (nodes.size() < 2 * i + 3)
            nodes.resize(2 * i + 3);
        nodes[2 * i + 1] = {umhülle(kleinere, mesh), knoten.facesBegin, mitte};
        nodes[2 * i + 2] = {umhülle(größere, mesh), mitte, knoten.facesEnd};
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection nächster;
    const BVH& baum = mesh.getBVH();
    const std::vector<BVH::Node>& knoten = baum.getNodes();
    std::vector<std::pair<size_t, bool>> stapel; // Knoten, und ob sein Würfel schon getroffen ist
    if (!knoten.empty())
        stapel.emplace_back(0, false);
    while (!stapel.empty())
    {
        const auto [i, getroffen] = stapel.back();
        stapel.pop_back();
        if (!getroffen && !intersect(knoten[i].bounds, ray))
            continue;
        const size_t links = 2 * i + 1, rechts = 2 * i + 2;
        if (rechts >= knoten.size() || knoten[links].facesEnd == 0)
        {
            for (const uint32_t fläche : baum.getFaceIndices(knoten[i]))
                if (const Intersection treffer = intersect(mesh.getTriangleFromFaceIndex(fläche), ray); treffer.t < nächster.t)
                    nächster = treffer;
            continue;
        }
        // der linke Würfel wird gleich geprüft, der rechte erst, wenn er an der Reihe ist
        stapel.emplace_back(rechts, false);
        if (intersect(knoten[links].bounds, ray))
            stapel.emplace_back(links, true);
    }
    return nächster;
}
