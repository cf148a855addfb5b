// expect: hits.special-rays
// untouched: a
// mistake: A component of the direction that is 0 becomes 1e-8, which is much beside a short direction.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"

#include <cmath>

static bool hitsBox(const AABB& box, const IntersectionRay& ray, float closest)
{
    float enter = ray.t_min;
    float leave = std::min(ray.t_max, closest);
    for (int axis = 0; axis < 3; ++axis) {
        const float along = ray.direction[axis] == 0.0f ? 1e-8f : ray.direction[axis];
        float t0 = (box.min[axis] - ray.origin[axis]) / along;
        float t1 = (box.max[axis] - ray.origin[axis]) / along;
        if (t0 > t1)
            std::swap(t0, t1);
        // a little slack against rounding
        enter = std::max(enter, t0 - 1e-6f * std::abs(t0));
        leave = std::min(leave, t1 + 1e-6f * std::abs(t1));
    }
    return enter <= leave;
}

void BVH::construct(const Mesh& mesh)
{
    const std::vector<TriangleIndices>& faces = mesh.getFaces();
    const std::vector<Point3D>& vertices = mesh.getVertices();
    faceIndices.resize(faces.size());
    for (size_t i = 0; i < faces.size(); ++i)
        faceIndices[i] = uint32_t(i);
    nodes.clear();
    nodes.push_back(Node{mesh.getBounds(), 0, uint32_t(faces.size())});

    uint32_t levelStart = 0;
    for (uint32_t level = 0; level < maxDepth && levelStart < nodes.size(); ++level) {
        const uint32_t levelEnd = 2 * levelStart + 1;
        for (uint32_t i = levelStart; i < levelEnd && i < nodes.size(); ++i) {
            const uint32_t b = nodes[i].facesBegin, e = nodes[i].facesEnd;
            if (e - b > numFacesPerLeaf) {
                const int axis = nodes[i].bounds.extents().maxDimension();
                const uint32_t m = b + (e - b + 1) / 2;
                auto less = [&](uint32_t l, uint32_t r) {
                    const auto &x = faces[l], &y = faces[r];
                    return (vertices[x.v1][axis] + vertices[x.v2][axis] + vertices[x.v3][axis]) / 3.f <
                           (vertices[y.v1][axis] + vertices[y.v2][axis] + vertices[y.v3][axis]) / 3.f;
                };
                std::nth_element(faceIndices.begin() + b, faceIndices.begin() + m, faceIndices.begin() + e, less);
                if (nodes.size() <= 2 * i + 2)
                    nodes.resize(2 * i + 3);
                nodes[2 * i + 1].facesBegin = b;
                nodes[2 * i + 1].facesEnd = m;
                nodes[2 * i + 2].facesBegin = m;
                nodes[2 * i + 2].facesEnd = e;
                for (uint32_t k = b; k < e; ++k) {
                    AABB& box = nodes[2 * i + (k < m ? 1 : 2)].bounds;
                    const TriangleIndices& f = faces[faceIndices[k]];
                    box.extend(vertices[f.v1]);
                    box.extend(vertices[f.v2]);
                    box.extend(vertices[f.v3]);
                }
            }
        }
        levelStart = levelEnd;
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    const auto& nodes = mesh.getBVH().getNodes();
    if (nodes.empty())
        return best;
    std::vector<uint32_t> todo{0};
    while (!todo.empty()) {
        const uint32_t i = todo.back();
        todo.pop_back();
        if (!hitsBox(nodes[i].bounds, ray, best.t + 1e-5f * std::abs(best.t)))
            continue;
        if (2 * i + 1 < nodes.size() && nodes[2 * i + 1].facesEnd != 0) {
            todo.push_back(2 * i + 2);
            todo.push_back(2 * i + 1);
        } else {
            for (uint32_t face : mesh.getBVH().getFaceIndices(nodes[i])) {
                const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
                if (hit.t < best.t)
                    best = hit;
            }
        }
    }
    return best;
}
