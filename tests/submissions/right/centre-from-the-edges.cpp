// right: the centre as first corner plus a third of both edges of the Triangle; the deepest possible stack of exactly maxDepth far children
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "triangle.h"

inline Point3D triangleCenter(const Triangle& triangle) {
    return triangle.v1 + (triangle.v1v2 + triangle.v1v3) / 3.0f;
}

inline AABB& operator+=(AABB& box, const Triangle& triangle) {
    box.extend(triangle.v1);
    box.extend(triangle.v2);
    box.extend(triangle.v3);
    return box;
}

inline uint32_t operator+(const BVH::Node& node) { return node.facesEnd - node.facesBegin; }

template <uint8_t Axis>
struct ByCenter {
    const Mesh& mesh;
    bool operator()(uint32_t a, uint32_t b) const {
        return triangleCenter(mesh.getTriangleFromFaceIndex(a))[Axis] <
               triangleCenter(mesh.getTriangleFromFaceIndex(b))[Axis];
    }
};

template <uint8_t Axis>
void medianSplit(const Mesh& mesh, std::span<uint32_t> faces) {
    std::nth_element(faces.begin(), faces.begin() + faces.size() / 2, faces.end(), ByCenter<Axis>{mesh});
}

void BVH::construct(const Mesh& mesh) {
    *this = {};
    faceIndices.resize(mesh.getFaces().size());
    std::iota(faceIndices.begin(), faceIndices.end(), 0);
    nodes.push_back(Node{mesh.getBounds(), 0, static_cast<uint32_t>(faceIndices.size())});

    for (size_t i = 0; i < nodes.size(); ++i) {
        if (+nodes[i] <= numFacesPerLeaf || i >= (size_t{1} << maxDepth) - 1) continue;
        const std::span<uint32_t> faces = getFaceIndices(nodes[i]);
        switch (nodes[i].bounds.extents().maxDimension()) {
            case 0: medianSplit<0>(mesh, faces); break;
            case 1: medianSplit<1>(mesh, faces); break;
            case 2: medianSplit<2>(mesh, faces); break;
        }
        Node left{{}, nodes[i].facesBegin, nodes[i].facesBegin + +nodes[i] / 2};
        Node right{{}, left.facesEnd, nodes[i].facesEnd};
        for (auto* child : {&left, &right})
            for (auto face : getFaceIndices(*child)) child->bounds += mesh.getTriangleFromFaceIndex(face);
        nodes.resize(std::max(nodes.size(), 2 * i + 3));
        nodes[2 * i + 1] = left;
        nodes[2 * i + 2] = right;
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    Intersection closest;
    if (nodes.empty() || !intersect(nodes.front().bounds, ray)) return closest;

    // Only the second child of each level waits: a path has at most maxDepth of them.
    size_t waiting[BVH::maxDepth];
    size_t* top = waiting;
    size_t i = 0;
    for (;;) {
        const size_t left = 2 * i + 1, right = 2 * i + 2;
        if (right < nodes.size() && nodes[left].facesEnd != 0) {
            const bool hitsLeft = intersect(nodes[left].bounds, ray);
            const bool hitsRight = intersect(nodes[right].bounds, ray);
            if (hitsLeft && hitsRight) {
                *top++ = right;
                i = left;
                continue;
            }
            if (hitsLeft || hitsRight) {
                i = hitsLeft ? left : right;
                continue;
            }
        } else {
            for (auto face : bvh.getFaceIndices(nodes[i])) {
                auto hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
                if (hit.t < closest.t) closest = hit;
            }
        }
        if (top == waiting) return closest;
        i = *--top;
    }
}
