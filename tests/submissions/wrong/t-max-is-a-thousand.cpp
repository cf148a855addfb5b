// expect: hits.closest-wins
// untouched: a
// mistake: t_max is limited to 1000.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <algorithm>
#include <bit>
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

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection result;
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    if (nodes.empty())
        return result;
    IntersectionRay shrinking = ray;
    shrinking.t_max = std::min(ray.t_max, 1000.0f);
    std::vector<size_t> stack;
    stack.reserve(64);
    stack.push_back(0);
    while (!stack.empty()) {
        const size_t i = stack.back();
        stack.pop_back();
        if (!intersect(nodes[i].bounds, shrinking))
            continue;
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd != 0) {
            stack.push_back(2 * i + 2);
            stack.push_back(2 * i + 1);
        } else {
            for (uint32_t face : bvh.getFaceIndices(nodes[i]))
                if (const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), shrinking)) {
                    result = hit;
                    shrinking.t_max = hit.t;
                }
        }
    }
    return result;
}
