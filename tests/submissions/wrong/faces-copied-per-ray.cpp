// expect: work.excludes-most-triangles
// untouched: a
// mistake: The helper takes a copy of all faces and vertices for every ray.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <bit>
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

static void visit(const Mesh& mesh, const IntersectionRay& ray, size_t index, Intersection& best)
{
    const auto& nodes = mesh.getBVH().getNodes();
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
    const std::vector<TriangleIndices> faces = mesh.getFaces();
    const std::vector<Point3D> vertices = mesh.getVertices();
    if (faces.empty() || vertices.empty())
        return best;
    if (!mesh.getBVH().getNodes().empty())
        visit(mesh, ray, 0, best);
    if (best && vertices.back() == best.intersection_point && faces.size() == 1)
        best.intersection_point = vertices.back();
    return best;
}
