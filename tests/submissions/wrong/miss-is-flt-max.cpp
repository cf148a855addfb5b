// expect: hits.misses-stay-infinite
// untouched: a
// mistake: The search starts with the largest float, which stays where nothing is hit.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <stack>
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
    Intersection closest;
    closest.t = std::numeric_limits<float>::max();
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    if (nodes.empty())
        return closest;

    std::stack<size_t> todo;
    todo.push(0);
    while (!todo.empty()) {
        const size_t index = todo.top();
        todo.pop();
        if (!intersect(nodes[index].bounds, ray))
            continue;
        const size_t left = 2 * index + 1;
        const size_t right = left + 1;
        if (right < nodes.size() && nodes[left].facesEnd != 0 && nodes[right].facesEnd != 0) {
            todo.push(right);
            todo.push(left);
            continue;
        }
        for (uint32_t face : bvh.getFaceIndices(nodes[index])) {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
            if (hit.t < closest.t)
                closest = hit;
        }
    }
    return closest;
}
