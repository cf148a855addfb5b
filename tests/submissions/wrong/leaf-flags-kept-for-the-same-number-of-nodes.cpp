// expect: hits.calls-are-independent
// untouched: a
// mistake: Which nodes are leaves is kept as long as trees have the same number of nodes.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

void BVH::construct(const Mesh& mesh) {
    *this = {};
    const uint32_t numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.push_back(Node{mesh.getBounds(), 0, numFaces});

    for (uint32_t i = 0; i < nodes.size(); ++i) {
        const Node node = nodes[i];
        const uint32_t count = node.facesEnd - node.facesBegin;
        const uint32_t depth = static_cast<uint32_t>(std::bit_width(i + 1)) - 1;
        if (count <= numFacesPerLeaf || depth >= maxDepth) {
            continue;
        }
        const size_t axis = node.bounds.extents().maxDimension();
        const auto center = [&](uint32_t face) {
            const Triangle t = mesh.getTriangleFromFaceIndex(face);
            return (t.v1[axis] + t.v2[axis] + t.v3[axis]) / 3.0f;
        };
        const uint32_t middle = node.facesBegin + count / 2;
        std::nth_element(faceIndices.begin() + node.facesBegin, faceIndices.begin() + middle,
                         faceIndices.begin() + node.facesEnd,
                         [&](uint32_t a, uint32_t b) { return center(a) < center(b); });

        Node left{{}, node.facesBegin, middle};
        Node right{{}, middle, node.facesEnd};
        for (Node* child : {&left, &right}) {
            for (uint32_t face : getFaceIndices(*child)) {
                const Triangle t = mesh.getTriangleFromFaceIndex(face);
                child->bounds.extend(t.v1);
                child->bounds.extend(t.v2);
                child->bounds.extend(t.v3);
            }
        }
        if (nodes.size() < 2 * size_t{i} + 3) {
            nodes.resize(2 * size_t{i} + 3);
        }
        nodes[2 * i + 1] = left;
        nodes[2 * i + 2] = right;
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    Intersection closest;

    // Worked out once per tree, so that the walk itself looks at one node only.
    static thread_local std::vector<bool> isLeaf;
    if (isLeaf.size() != nodes.size()) {
        isLeaf.assign(nodes.size(), false);
        for (size_t i = 0; i < nodes.size(); ++i) {
            isLeaf[i] = 2 * i + 2 >= nodes.size() || nodes[2 * i + 1].facesEnd == 0;
        }
    }

    size_t index = 0;
    while (index < nodes.size()) {
        if (intersect(nodes[index].bounds, ray)) {
            if (!isLeaf[index]) {
                index = 2 * index + 1;
                continue;
            }
            for (const uint32_t face : bvh.getFaceIndices(nodes[index])) {
                const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
                if (hit.t < closest.t) {
                    closest = hit;
                }
            }
        }
        // Up from right children, then over to the right sibling.
        while (index != 0 && index % 2 == 0) {
            index = (index - 1) / 2;
        }
        if (index == 0) {
            break;
        }
        ++index;
    }
    return closest;
}
