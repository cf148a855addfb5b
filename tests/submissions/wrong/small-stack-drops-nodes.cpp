// expect: hits.closest-wins
// untouched: a
// mistake: The stack has room for eight nodes, what does not fit is dropped.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <algorithm>
#include <iostream>
#include <numeric>
#include <vector>

namespace {
struct Job { size_t node; uint32_t depth; };
}

void BVH::construct(const Mesh& mesh)
{
    const size_t count = mesh.getFaces().size();
    std::vector<Point3D> centers;
    centers.reserve(count);
    faceIndices.clear();
    faceIndices.reserve(count);
    for (size_t i = 0; i < count; ++i) {
        const auto t = mesh.getTriangleFromFaceIndex(i);
        centers.push_back((t.v1 + t.v2 + t.v3) / 3.f);
        faceIndices.push_back(static_cast<uint32_t>(i));
    }

    nodes.clear();
    nodes.push_back(Node{.bounds = mesh.getBounds(), .facesBegin = 0, .facesEnd = static_cast<uint32_t>(count)});
    std::vector<Job> jobs{{0, 0}};
    while (!jobs.empty()) {
        const Job job = jobs.back();
        jobs.pop_back();
        const Node parent = nodes[job.node];
        const uint32_t size = parent.facesEnd - parent.facesBegin;
        if (size <= numFacesPerLeaf || job.depth == maxDepth)
            continue;

        const auto axis = parent.bounds.extents().maxDimension();
        auto faces = getFaceIndices(parent);
        std::sort(faces.begin(), faces.end(), [&centers, axis](uint32_t a, uint32_t b) { return centers[a][axis] < centers[b][axis]; });

        const uint32_t split = parent.facesBegin + size / 2;
        Node children[2] = {{AABB{}, parent.facesBegin, split}, {AABB{}, split, parent.facesEnd}};
        if (nodes.size() < 2 * job.node + 3)
            nodes.resize(2 * job.node + 3);
        for (size_t c = 0; c < 2; ++c) {
            for (uint32_t face : getFaceIndices(children[c])) {
                const auto t = mesh.getTriangleFromFaceIndex(face);
                AABB box;
                box.extend(t.v1);
                box.extend(t.v2);
                box.extend(t.v3);
                children[c].bounds.extend(box);
            }
            nodes[2 * job.node + 1 + c] = children[c];
            jobs.push_back({2 * job.node + 1 + c, job.depth + 1});
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
            if (hoehe < 8) stapel[hoehe++] = links;
            if (hoehe < 8) stapel[hoehe++] = rechts;
        } else {
            for (auto f : baum.getFaceIndices(knoten[i])) {
                auto treffer = intersect(mesh.getTriangleFromFaceIndex(f), ray);
                if (treffer.t < naechster.t) naechster = treffer;
            }
        }
    }
    return naechster;
}
