// expect: hits.memory-is-safe
// untouched: a
// mistake: The walk calls itself for each node, so the stack is as deep as there are nodes to visit.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

namespace {

/// Three times the centre is as good as the centre for comparing.
Point3D centerOf(const Mesh& mesh, uint32_t face) {
    const Triangle triangle = mesh.getTriangleFromFaceIndex(face);
    return triangle.v1 + triangle.v2 + triangle.v3;
}

AABB boundsOf(const Mesh& mesh, std::span<const uint32_t> faces) {
    AABB box;
    for (const uint32_t face : faces) {
        const Triangle triangle = mesh.getTriangleFromFaceIndex(face);
        box.extend(triangle.v1);
        box.extend(triangle.v2);
        box.extend(triangle.v3);
    }
    return box;
}

} // namespace

void BVH::construct(const Mesh& mesh) {
    *this = {};
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);
    nodes.push_back(Node{mesh.getBounds(), 0, numFaces});

    std::vector<Point3D> centers(numFaces);
    for (uint32_t face = 0; face < numFaces; ++face) {
        centers[face] = centerOf(mesh, face);
    }

    for (size_t i = 0; i < nodes.size(); ++i) {
        const Node node = nodes[i];
        const uint32_t depth = std::bit_width(i + 1) - 1;
        if (node.facesEnd - node.facesBegin <= numFacesPerLeaf || depth >= maxDepth) {
            continue;
        }
        const uint8_t axis = node.bounds.extents().maxDimension();
        const uint32_t middle = node.facesBegin + (node.facesEnd - node.facesBegin) / 2;
        std::nth_element(faceIndices.begin() + node.facesBegin, faceIndices.begin() + middle,
                         faceIndices.begin() + node.facesEnd, [&](uint32_t a, uint32_t b) {
                             return centers[a][axis] < centers[b][axis];
                         });
        Node left{{}, node.facesBegin, middle};
        Node right{{}, middle, node.facesEnd};
        left.bounds = boundsOf(mesh, getFaceIndices(left));
        right.bounds = boundsOf(mesh, getFaceIndices(right));
        if (nodes.size() < 2 * i + 3) {
            nodes.resize(2 * i + 3);
        }
        nodes[2 * i + 1] = left;
        nodes[2 * i + 2] = right;
    }
}

/// The node behind the whole subtree of `i`; 0 if there is none.
static size_t behind(size_t i) {
    while (i != 0 && i % 2 == 0) {
        i = i / 2 - 1;
    }
    return i == 0 ? 0 : i + 1;
}

/// The closest hit in node `i` or in anything that is visited after it.
static Intersection walk(const Mesh& mesh, const IntersectionRay& ray, size_t i) {
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    IntersectionRay shortened = ray;
    Intersection closest;
    size_t next = behind(i);
    if (intersect(nodes[i].bounds, ray)) {
        const size_t left = 2 * i + 1;
        if (left + 1 < nodes.size() && nodes[left].facesEnd != 0) {
            next = left;
        } else {
            for (const uint32_t face : bvh.getFaceIndices(nodes[i])) {
                const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), shortened);
                if (hit.t < closest.t) {
                    closest = hit;
                    shortened.t_max = hit.t;
                }
            }
        }
    }
    if (next == 0) {
        return closest;
    }
    const Intersection later = walk(mesh, shortened, next);
    return later.t < closest.t ? later : closest;
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    if (mesh.getBVH().getNodes().empty()) {
        return {};
    }
    return walk(mesh, ray, 0);
}
