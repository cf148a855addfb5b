// expect: hits.survives-every-ray
// untouched: a
// mistake: Three floats of a ray are loaded as four, as if they lay at a multiple of 16 bytes.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <immintrin.h>

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

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const BVH& bvh = mesh.getBVH();
    const std::vector<BVH::Node>& nodes = bvh.getNodes();
    Intersection closest;
    if (nodes.empty()) {
        return closest;
    }

    IntersectionRay shortened = ray; // ends at the closest hit so far
    // The signs of all three components at once.
    const int negative = _mm_movemask_ps(_mm_load_ps(&ray.inv_direction.x));
    std::vector<size_t> stack{0};
    while (!stack.empty()) {
        const size_t i = stack.back();
        stack.pop_back();
        if (!intersect(nodes[i].bounds, shortened)) {
            continue;
        }
        const size_t left = 2 * i + 1;
        if (left + 1 < nodes.size() && nodes[left].facesEnd != 0) {
            // Go to the nearer child first.
            const Vector3D apart = nodes[left + 1].bounds.center() - nodes[left].bounds.center();
            const uint8_t axis =
                Vector3D{std::abs(apart.x), std::abs(apart.y), std::abs(apart.z)}.maxDimension();
            const bool leftFirst = (apart[axis] < 0) == ((negative >> axis & 1) != 0);
            stack.push_back(leftFirst ? left + 1 : left);
            stack.push_back(leftFirst ? left : left + 1);
            continue;
        }
        for (const uint32_t face : bvh.getFaceIndices(nodes[i])) {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), shortened);
            if (hit.t < closest.t) {
                closest = hit;
                shortened.t_max = hit.t;
            }
        }
    }
    return closest;
}
