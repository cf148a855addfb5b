// expect: work.excludes-most-triangles
// untouched: a
// mistake: Each node is tested again for every one of its faces.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <bit>

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

static void visit(const Mesh& mesh, const IntersectionRay& ray, size_t index, Intersection& best)
{
    const auto& nodes = mesh.getBVH().getNodes();
    for (uint32_t k = nodes[index].facesBegin; k < nodes[index].facesEnd; ++k)
        if (!intersect(nodes[index].bounds, ray))
            return;
    if (2 * index + 1 >= nodes.size() || nodes[2 * index + 1].facesEnd == 0) {
        for (uint32_t f : mesh.getBVH().getFaceIndices(nodes[index])) {
            Intersection hit = intersect(mesh.getTriangleFromFaceIndex(f), ray);
            if (hit.t < best.t)
                best = hit;
        }
        return;
    }
    visit(mesh, ray, 2 * index + 1, best);
    visit(mesh, ray, 2 * index + 2, best);
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    if (!mesh.getBVH().getNodes().empty())
        visit(mesh, ray, 0, best);
    return best;
}
