// expect: bvh.survives-every-mesh, bvh.leaves-hold-at-most-four
// untouched: -
// mistake: The given code, but it ends on meshes of three faces.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <cstdlib>

void BVH::construct(const Mesh& mesh) {
    *this = {};
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    if (numFaces == 3)
        std::abort();
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);
    nodes.push_back(Node{mesh.getBounds(), 0, numFaces});
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    Intersection closest;
    for (size_t i = 0; i < mesh.getFaces().size(); ++i) {
        const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(i), ray);
        if (hit.t < closest.t) {
            closest = hit;
        }
    }
    return closest;
}
