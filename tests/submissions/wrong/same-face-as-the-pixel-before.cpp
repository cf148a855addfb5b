// expect: image.equals-mitsuba
// untouched: a
// mistake: A ray from the same origin as the one before, and nearly parallel to it, is tested against that one's face first and ends there.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <utility>
#include <vector>

void BVH::construct(const Mesh& mesh)
{
    const uint32_t n = uint32_t(mesh.getFaces().size());
    *this = {};
    faceIndices.resize(n);
    for (uint32_t i = 0; i < n; ++i)
        faceIndices[i] = i;
    nodes.push_back({mesh.getBounds(), 0, n});

    const size_t firstOfLastLevel = (size_t(1) << maxDepth) - 1;
    for (size_t i = 0; i < nodes.size() && i < firstOfLastLevel; ++i) {
        const uint32_t begin = nodes[i].facesBegin;
        const uint32_t end = nodes[i].facesEnd;
        if (end - begin <= numFacesPerLeaf)
            continue;
        const uint8_t axis = nodes[i].bounds.extents().maxDimension();
        const auto center = [&](uint32_t f) {
            const Triangle t = mesh.getTriangleFromFaceIndex(f);
            return (t.v1[axis] + t.v2[axis] + t.v3[axis]) * (1.f / 3.f);
        };
        const uint32_t mid = (begin + end) / 2;
        std::nth_element(faceIndices.begin() + begin, faceIndices.begin() + mid, faceIndices.begin() + end,
                         [&](uint32_t a, uint32_t b) { return center(a) < center(b); });
        const auto boxOf = [&](uint32_t from, uint32_t to) {
            AABB box;
            for (uint32_t k = from; k < to; ++k) {
                const Triangle t = mesh.getTriangleFromFaceIndex(faceIndices[k]);
                box.min = min(box.min, min(t.v1, min(t.v2, t.v3)));
                box.max = max(box.max, max(t.v1, max(t.v2, t.v3)));
            }
            return box;
        };
        nodes.resize(std::max(nodes.size(), 2 * i + 3));
        nodes[2 * i + 1] = Node{boxOf(begin, mid), begin, mid};
        nodes[2 * i + 2] = Node{boxOf(mid, end), mid, end};
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    Intersection best;
    thread_local Point3D lastOrigin;
    thread_local Vector3D lastDirection;
    thread_local const Mesh* lastMesh = nullptr;
    thread_local uint32_t lastFace = 0;
    const Vector3D step = ray.direction - lastDirection;
    const bool neighbour = lastMesh == &mesh && lastOrigin == ray.origin && !(step == Vector3D{}) &&
                           step.norm() < 0.05f * ray.direction.norm();
    lastOrigin = ray.origin;
    lastDirection = ray.direction;
    lastMesh = &mesh;
    if (neighbour && lastFace < mesh.getFaces().size())
        if (const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(lastFace), ray))
            return hit;
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
                if (hit.t < best.t) {
                    best = hit;
                    lastFace = face;
                }
            }
        } else if (intersect(nodes[i].bounds, ray)) {
            todo.push_back(2 * i + 1);
            todo.push_back(2 * i + 2);
        }
    }
    return best;
}
