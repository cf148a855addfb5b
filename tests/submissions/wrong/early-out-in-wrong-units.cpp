// expect: hits.special-rays
// untouched: a
// mistake: The entry distance is measured in units of length, the hit in units of the direction.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <bit>
#include <cmath>
#include <vector>

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

// Where the ray enters the box, or infinity. Rounded outwards a little.
static float entry(const AABB& box, const IntersectionRay& ray)
{
    if (!intersect(box, ray))
        return infinity;
    float t = ray.t_min;
    for (size_t k = 0; k < 3; ++k) {
        const float a = (box.min[k] - ray.origin[k]) * ray.inv_direction[k];
        const float b = (box.max[k] - ray.origin[k]) * ray.inv_direction[k];
        const float near = a < b ? a : b;
        if (near > t && std::isfinite(near))
            t = near;
    }
    return t * ray.direction.norm();
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    struct Item { size_t node; float t; };
    Intersection best;
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    if (nodes.empty())
        return best;
    std::vector<Item> stack{{0, entry(nodes[0].bounds, ray)}};
    while (!stack.empty()) {
        const Item item = stack.back();
        stack.pop_back();
        const float margin = 1e-5f * (std::abs(item.t) + std::abs(best.t));
        if (item.t == infinity || (best && item.t > best.t + margin))
            continue;
        const size_t left = 2 * item.node + 1;
        if (left + 1 < nodes.size() && nodes[left].facesEnd != 0) {
            Item near{left, entry(nodes[left].bounds, ray)};
            Item far{left + 1, entry(nodes[left + 1].bounds, ray)};
            if (far.t < near.t)
                std::swap(near, far);
            stack.push_back(far);
            stack.push_back(near);
            continue;
        }
        for (auto face : bvh.getFaceIndices(nodes[item.node])) {
            const auto hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
            if (hit.t < best.t)
                best = hit;
        }
    }
    return best;
}
