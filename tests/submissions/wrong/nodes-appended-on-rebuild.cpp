// expect: bvh.survives-every-mesh
// untouched: b
// mistake: nodes is not cleared, a second construct leaves the old tree in front.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <bit>
#include <queue>

void BVH::construct(const Mesh& mesh)
{
    uint32_t numFaces = mesh.getFaces().size();
    faceIndices.clear();
    for (uint32_t i = 0; i != numFaces; i++)
        faceIndices.push_back(i);
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
    Intersection closest;
    const auto& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    std::queue<uint32_t> open;
    if (!nodes.empty() && nodes[0].facesEnd > 0)
        open.push(0);
    for (; !open.empty(); open.pop()) {
        const uint32_t i = open.front();
        if (!intersect(nodes[i].bounds, ray))
            continue;
        if (const uint32_t left = 2 * i + 1; left < nodes.size() && nodes[left].facesEnd != 0) {
            open.push(left);
            open.push(left + 1);
            continue;
        }
        for (uint32_t f : bvh.getFaceIndices(nodes[i]))
            if (auto hit = intersect(mesh.getTriangleFromFaceIndex(f), ray); hit.t < closest.t)
                closest = hit;
    }
    return closest;
}
