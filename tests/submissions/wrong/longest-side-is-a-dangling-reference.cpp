// expect: bvh.memory-is-safe
// untouched: b
// mistake: The longest side is a reference to a local variable that is gone.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

void BVH::construct(const Mesh& mesh) {
    *this = {};

    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);
    nodes.push_back(Node{mesh.getBounds(), 0, numFaces});

    const auto centre = [&mesh](uint32_t face) {
        const Triangle t = mesh.getTriangleFromFaceIndex(face);
        return (t.v1 + t.v2 + t.v3) / 3.0f;
    };

    const auto longest = [](const AABB& box) -> const float& {
        const Vector3D extents = box.extents();
        return std::max(std::max(extents.x, extents.y), extents.z);
    };

    for (size_t i = 0; i < nodes.size(); ++i) {
        const Node node = nodes[i];
        const uint32_t count = node.facesEnd - node.facesBegin;
        const auto depth = static_cast<uint32_t>(std::bit_width(i + 1) - 1);
        if (count <= numFacesPerLeaf || depth >= maxDepth) {
            continue;
        }

        const float& length = longest(node.bounds);
        uint8_t axis = 2;
        for (uint8_t k = 0; k < 2 && axis == 2; ++k) {
            if (node.bounds.extents()[k] == length) {
                axis = k;
            }
        }
        const uint32_t middle = node.facesBegin + count / 2;
        const auto less = [&](uint32_t a, uint32_t b) { return centre(a)[axis] < centre(b)[axis]; };
        std::nth_element(faceIndices.begin() + node.facesBegin, faceIndices.begin() + middle,
                         faceIndices.begin() + node.facesEnd, less);

        Node left{AABB{}, node.facesBegin, middle};
        for (const uint32_t face : getFaceIndices(left)) {
            const Triangle t = mesh.getTriangleFromFaceIndex(face);
            left.bounds.extend(t.v1);
            left.bounds.extend(t.v2);
            left.bounds.extend(t.v3);
        }
        Node right{AABB{}, middle, node.facesEnd};
        for (const uint32_t face : getFaceIndices(right)) {
            const Triangle t = mesh.getTriangleFromFaceIndex(face);
            right.bounds.extend(t.v1);
            right.bounds.extend(t.v2);
            right.bounds.extend(t.v3);
        }

        if (nodes.size() < 2 * i + 3) {
            nodes.resize(2 * i + 3);
        }
        nodes[2 * i + 1] = left;
        nodes[2 * i + 2] = right;
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    Intersection closest;
    if (nodes.empty()) {
        return closest;
    }
    std::vector<size_t> open{0};
    while (!open.empty()) {
        const size_t i = open.back();
        open.pop_back();
        if (!intersect(nodes[i].bounds, ray)) {
            continue;
        }
        const size_t left = 2 * i + 1;
        const size_t right = 2 * i + 2;
        if (right < nodes.size() && nodes[left].facesEnd != 0) {
            open.push_back(right);
            open.push_back(left);
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
