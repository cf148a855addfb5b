// expect: hits.special-rays
// untouched: a
// mistake: The direction is normalised, so t is a length and t_min and t_max are compared in the wrong unit.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <cmath>
#include <utility>
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

Intersection intersect(const Mesh& mesh, const IntersectionRay& given)
{
    const IntersectionRay ray(Ray{given.origin, given.direction.normalized(), given.t_min, given.t_max});
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    Intersection best;
    std::vector<uint32_t> todo;
    if (!nodes.empty())
        todo.push_back(0);
    while (!todo.empty()) {
        const uint32_t i = todo.back();
        todo.pop_back();
        const bool leaf = 2 * i + 1 >= nodes.size() || nodes[2 * i + 1].facesEnd == 0;
        if (leaf) {  // the triangles are tested at once, the leaf's own box is not worth it
            for (uint32_t face : bvh.getFaceIndices(nodes[i])) {
                const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
                if (hit.t < best.t)
                    best = hit;
            }
        } else if (intersect(nodes[i].bounds, ray)) {
            todo.push_back(2 * i + 1);
            todo.push_back(2 * i + 2);
        }
    }
    return best;
}
