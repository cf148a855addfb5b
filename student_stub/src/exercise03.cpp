#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

/// Part a): builds the tree.
void BVH::construct(const Mesh& mesh) {
    *this = {};

    // The root contains all faces, in the order of the mesh.
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);
    nodes.push_back(Node{mesh.getBounds(), 0, numFaces});

    // TODO a): Subdivide the nodes, in a loop, until they contain at most numFacesPerLeaf faces
    //          or maxDepth is reached.
}

/// Part b): finds the closest hit.
Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    // TODO b): Use mesh.getBVH() to test only those triangles whose boxes the ray intersects.
    Intersection closest;
    for (size_t i = 0; i < mesh.getFaces().size(); ++i) {
        const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(i), ray);
        if (hit.t < closest.t) {
            closest = hit;
        }
    }
    return closest;
}
