// expect: hits.special-rays
// untouched: a
// mistake: The own box test wants the entry to lie before the ray, so a box around the origin is missed.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <cmath>
#include <queue>

void BVH::construct(const Mesh& mesh)
{
    const uint32_t numFaces = uint32_t(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);

    nodes.clear();
    nodes.resize(2 * roundUpPowerOfTwo((numFaces + numFacesPerLeaf - 1) / numFacesPerLeaf) - 1);
    nodes[0] = Node{mesh.getBounds(), 0, numFaces};

    for (uint32_t depth = 0; depth < maxDepth; ++depth) {
        const uint32_t first = (1u << depth) - 1;
        for (uint32_t i = first; i <= 2 * first && 2 * i + 2 < nodes.size(); ++i) {
            const Node& node = nodes[i];
            if (node.facesEnd - node.facesBegin <= numFacesPerLeaf)
                continue;
            const auto faces = getFaceIndices(node);
            const auto axis = node.bounds.extents().maxDimension();
            const auto half = faces.size() / 2;
            auto key = [&](uint32_t f) { const auto t = mesh.getTriangleFromFaceIndex(f); return ((t.v1 + t.v2 + t.v3) / 3)[axis]; };
            std::nth_element(faces.begin(), faces.begin() + half, faces.end(), [&](auto a, auto b) { return key(a) < key(b); });

            Node& left = nodes[2 * i + 1];
            Node& right = nodes[2 * i + 2];
            left.facesBegin = node.facesBegin;
            left.facesEnd = right.facesBegin = node.facesBegin + uint32_t(half);
            right.facesEnd = node.facesEnd;
            for (size_t k = 0; k < faces.size(); ++k) {
                const auto t = mesh.getTriangleFromFaceIndex(faces[k]);
                AABB& box = k < half ? left.bounds : right.bounds;
                box.extend(t.v1); box.extend(t.v2); box.extend(t.v3);
            }
        }
    }
}

static bool hitsBox(const AABB& box, const IntersectionRay& ray, float closest)
{
    float enter = ray.t_min;
    float leave = std::min(ray.t_max, closest);
    for (int axis = 0; axis < 3; ++axis) {
        if (ray.direction[axis] == 0.0f) {
            if (ray.origin[axis] < box.min[axis] || ray.origin[axis] > box.max[axis])
                return false;
            continue;
        }
        float t0 = (box.min[axis] - ray.origin[axis]) / ray.direction[axis];
        float t1 = (box.max[axis] - ray.origin[axis]) / ray.direction[axis];
        if (t0 > t1)
            std::swap(t0, t1);
        // a little slack against rounding
        enter = std::max(enter, t0 - 1e-6f * std::abs(t0));
        leave = std::min(leave, t1 + 1e-6f * std::abs(t1));
    }
    return enter <= leave && enter > ray.t_min;
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
