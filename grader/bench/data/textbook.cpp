// What a solution looks like that follows the sheet word for word: every comparison looks its two
// centres up in the mesh, every box its triangles, and the ray is never shortened. It is right,
// and what `bvhgrade bench` compares with; nothing here is meant to be fast.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

namespace {

float centerOf(const Mesh& mesh, uint32_t face, uint8_t axis) {
    const Triangle triangle = mesh.getTriangleFromFaceIndex(face);
    return ((triangle.v1 + triangle.v2 + triangle.v3) / 3)[axis];
}

AABB boundsOf(const Mesh& mesh, std::span<const uint32_t> faces) {
    AABB bounds;
    for (const uint32_t face : faces) {
        const Triangle triangle = mesh.getTriangleFromFaceIndex(face);
        bounds.extend(triangle.v1);
        bounds.extend(triangle.v2);
        bounds.extend(triangle.v3);
    }
    return bounds;
}

} // namespace

void BVH::construct(const Mesh& mesh) {
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);
    nodes.assign(1, Node{mesh.getBounds(), 0, numFaces});

    for (uint32_t depth = 0; depth < maxDepth; ++depth) {
        const size_t begin = (size_t{1} << depth) - 1;
        const size_t end = std::min(2 * begin + 1, nodes.size());
        for (size_t i = begin; i < end; ++i) {
            const Node node = nodes[i];
            const std::span<uint32_t> faces = getFaceIndices(node);
            if (faces.size() <= numFacesPerLeaf) {
                continue;
            }
            const uint8_t axis = node.bounds.extents().maxDimension();
            const auto half = static_cast<uint32_t>(faces.size() / 2);
            std::nth_element(faces.begin(), faces.begin() + half, faces.end(),
                             [&](uint32_t a, uint32_t b) {
                                 return centerOf(mesh, a, axis) < centerOf(mesh, b, axis);
                             });
            if (nodes.size() < 2 * i + 3) {
                nodes.resize(2 * i + 3);
            }
            const uint32_t middle = node.facesBegin + half;
            nodes[2 * i + 1] = {boundsOf(mesh, faces.first(half)), node.facesBegin, middle};
            nodes[2 * i + 2] = {boundsOf(mesh, faces.subspan(half)), middle, node.facesEnd};
        }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const BVH& bvh = mesh.getBVH();
    const std::vector<BVH::Node>& nodes = bvh.getNodes();
    Intersection closest;
    std::vector<size_t> stack{0};
    while (!stack.empty() && !nodes.empty()) {
        const size_t i = stack.back();
        stack.pop_back();
        if (!intersect(nodes[i].bounds, ray)) {
            continue;
        }
        const size_t left = 2 * i + 1;
        const size_t right = 2 * i + 2;
        if (right < nodes.size() && nodes[left].facesEnd != 0 && nodes[right].facesEnd != 0) {
            stack.push_back(left);
            stack.push_back(right);
            continue;
        }
        for (const uint32_t face : bvh.getFaceIndices(nodes[i])) {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
            if (hit.t < closest.t) {
                closest = hit;
            }
        }
    }
    return closest;
}
