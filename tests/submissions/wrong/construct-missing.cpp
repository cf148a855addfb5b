// expect: bvh.survives-every-mesh
// untouched: b
// mistake: construct is not defined, only intersect is.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <algorithm>
#include <numeric>
#include <queue>
#include <stack>

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection closest;
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
