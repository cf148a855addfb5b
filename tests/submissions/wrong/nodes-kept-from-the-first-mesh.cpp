// expect: hits.calls-are-independent
// untouched: a
// mistake: The nodes of the first mesh are kept in a static reference.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <cmath>
#include <vector>

void BVH::construct(const Mesh& mesh)
{
    const uint32_t numFaces = uint32_t(mesh.getFaces().size());
    std::vector<Point3D> center(numFaces);
    std::vector<AABB> box(numFaces);
    faceIndices.resize(numFaces);
    for (uint32_t f = 0; f < numFaces; ++f) {
        const Triangle t = mesh.getTriangleFromFaceIndex(f);
        center[f] = (t.v1 + t.v2 + t.v3) / 3.f;
        box[f].extend(t.v1);
        box[f].extend(t.v2);
        box[f].extend(t.v3);
        faceIndices[f] = f;
    }
    nodes.clear();
    nodes.push_back(Node{mesh.getBounds(), 0, numFaces});
    std::vector<uint32_t> todo{0};
    for (size_t done = 0; done < todo.size(); ++done) {
        const uint32_t i = todo[done];
        const Node node = nodes[i];
        const uint32_t count = node.facesEnd - node.facesBegin;
        if (count <= numFacesPerLeaf || i + 1 >= (1u << maxDepth))
            continue;
        const auto faces = getFaceIndices(node);
        const auto axis = node.bounds.extents().maxDimension();
        std::nth_element(faces.begin(), faces.begin() + count / 2, faces.end(),
                         [&](uint32_t a, uint32_t b) { return center[a][axis] < center[b][axis]; });
        if (nodes.size() < 2 * i + 3)
            nodes.resize(2 * i + 3);
        nodes[2 * i + 1] = Node{{}, node.facesBegin, node.facesBegin + count / 2};
        nodes[2 * i + 2] = Node{{}, node.facesBegin + count / 2, node.facesEnd};
        for (uint32_t child : {2 * i + 1, 2 * i + 2}) {
            for (uint32_t f : getFaceIndices(nodes[child]))
                nodes[child].bounds.extend(box[f]);
            todo.push_back(child);
        }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    const BVH& bvh = mesh.getBVH();
    static const std::vector<BVH::Node> nodes = bvh.getNodes();
    if (!bvh.isConstructed())
        return best;

    size_t i = 0;
    for (;;) {
        const BVH::Node& node = nodes[i];
        if (intersect(node.bounds, ray)) {
            if (2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd > 0) {
                i = 2 * i + 1;
                continue;
            }
            for (const uint32_t face : bvh.getFaceIndices(node)) {
                const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
                if (hit && hit.t < best.t)
                    best = hit;
            }
        }
        while (i > 0 && i % 2 == 0)  // a right child: its parent is done as well
            i = (i - 1) / 2;
        if (i == 0)
            return best;
        ++i;  // the right sibling
    }
}
