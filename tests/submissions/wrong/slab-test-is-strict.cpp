// expect: hits.closest-wins
// untouched: a
// mistake: The own box test uses < and has no slack, so flat boxes are missed.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <bit>
#include <cmath>

void BVH::construct(const Mesh& mesh)
{
    uint32_t numFaces = mesh.getFaces().size();
    faceIndices.clear();
    for (uint32_t i = 0; i != numFaces; i++)
        faceIndices.push_back(i);
    nodes.clear();
    nodes.push_back(Node{mesh.getBounds(), 0, numFaces});

    for (uint32_t i = 0; i < nodes.size(); i++) {
        Node node = nodes[i];
        uint32_t level = std::bit_width(i + 1);  // 1 for the root
        if (level >= maxDepth || node.facesEnd - node.facesBegin <= numFacesPerLeaf)
            continue;

        Vector3D size = node.bounds.extents();
        int axis = 0;
        if (size.y > size[axis]) axis = 1;
        if (size.z > size[axis]) axis = 2;

        std::span<uint32_t> faces = getFaceIndices(node);
        size_t half = faces.size() / 2;
        std::nth_element(faces.begin(), faces.begin() + half, faces.end(), [&](uint32_t a, uint32_t b) {
            Triangle s = mesh.getTriangleFromFaceIndex(a);
            Triangle t = mesh.getTriangleFromFaceIndex(b);
            return s.v1[axis] / 3 + s.v2[axis] / 3 + s.v3[axis] / 3 < t.v1[axis] / 3 + t.v2[axis] / 3 + t.v3[axis] / 3;
        });

        if (nodes.size() < 2 * i + 3)
            nodes.resize(2 * i + 3);
        for (int side = 0; side < 2; side++) {
            Node& child = nodes[2 * i + 1 + side];
            child.facesBegin = node.facesBegin + (side ? half : 0);
            child.facesEnd = side ? node.facesEnd : node.facesBegin + half;
            child.bounds = AABB();
            for (uint32_t f : getFaceIndices(child)) {
                Triangle t = mesh.getTriangleFromFaceIndex(f);
                child.bounds.extend(t.v1);
                child.bounds.extend(t.v2);
                child.bounds.extend(t.v3);
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
        enter = std::max(enter, t0);
        leave = std::min(leave, t1);
    }
    return enter < leave;
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
