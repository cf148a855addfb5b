// An exception says that a node is a leaf, and leaves frames with large local variables behind.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

namespace {

struct IsLeaf {};

/// The boxes of both halves, and where the second one begins.
struct Halves {
    AABB boxes[2];
    uint32_t middle = 0;
};

void demandSplit(const BVH::Node& node, size_t depth) {
    std::array<uint32_t, 48> reasons;
    reasons.fill(node.facesEnd - node.facesBegin);
    if (reasons[depth % reasons.size()] <= BVH::numFacesPerLeaf || depth >= BVH::maxDepth) {
        throw IsLeaf();
    }
}

Halves halve(const Mesh& mesh, const BVH::Node& node, std::span<uint32_t> faces, size_t depth) {
    std::array<Point3D, 24> corners;
    demandSplit(node, depth);
    const uint8_t axis = node.bounds.extents().maxDimension();
    const auto half = faces.size() / 2;
    const auto sumOfCorners = [&](uint32_t face) {
        const Triangle t = mesh.getTriangleFromFaceIndex(face);
        return (t.v1 + t.v2 + t.v3)[axis];
    };
    std::nth_element(faces.begin(), faces.begin() + half, faces.end(),
                     [&](uint32_t a, uint32_t b) { return sumOfCorners(a) < sumOfCorners(b); });
    Halves made;
    made.middle = node.facesBegin + static_cast<uint32_t>(half);
    for (size_t k = 0; k < faces.size(); ++k) {
        const Triangle t = mesh.getTriangleFromFaceIndex(faces[k]);
        corners[0] = t.v1;
        corners[1] = t.v2;
        corners[2] = t.v3;
        for (const Point3D& corner : std::span(corners).first(3)) {
            made.boxes[k < half ? 0 : 1].extend(corner);
        }
    }
    return made;
}

/// Fills an array that lies where the abandoned frames were.
[[gnu::noinline]] uint32_t zero(size_t place) {
    std::array<uint32_t, 400> reused;
    reused.fill(0);
    return reused[place % reused.size()];
}

} // namespace

void BVH::construct(const Mesh& mesh) {
    const auto count = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(count);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.assign(1, Node{mesh.getBounds(), 0, count});
    for (size_t i = 0; i < nodes.size(); ++i) {
        const Node node = nodes[i];
        if (i > 0 && node.facesEnd == 0) {
            continue;
        }
        try {
            const size_t depth = std::bit_width(i + 1) - 1;
            const Halves made = halve(mesh, node, getFaceIndices(node), depth);
            nodes.resize(std::max(nodes.size(), 2 * i + 3));
            nodes[2 * i + 1] = {made.boxes[0], node.facesBegin, made.middle};
            nodes[2 * i + 2] = {made.boxes[1], made.middle, node.facesEnd};
        } catch (const IsLeaf&) {
            nodes[i].facesBegin += zero(i);
        }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    Intersection closest;
    std::vector<size_t> open;
    if (!nodes.empty()) {
        open.push_back(0);
    }
    while (!open.empty()) {
        const size_t i = open.back();
        open.pop_back();
        if (!intersect(nodes[i].bounds, ray)) {
            continue;
        }
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd > 0) {
            open.push_back(2 * i + 2);
            open.push_back(2 * i + 1);
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
