// expect: bvh.is-readable
// untouched: b
// mistake: Half the number of faces is used as an absolute index for the end of the left child.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <array>
#include <functional>

namespace {

constexpr std::array<float Point3D::*, 3> component{&Point3D::x, &Point3D::y, &Point3D::z};

void split(const Mesh& mesh, std::span<uint32_t> faces, int axis)
{
    const auto center = [&](uint32_t f) {
        const Triangle t = mesh.getTriangleFromFaceIndex(f);
        return (t.v1.*component[axis] + t.v2.*component[axis] + t.v3.*component[axis]) / 3.f;
    };
    std::ranges::nth_element(faces, faces.begin() + faces.size() / 2, std::ranges::less{}, center);
}

// overloaded: this one chooses the axis
void split(const Mesh& mesh, std::span<uint32_t> faces, const AABB& box)
{
    split(mesh, faces, static_cast<int>(box.extents().maxDimension()));
}

AABB boundsOf(const Mesh& mesh, std::span<const uint32_t> faces)
{
    AABB box;
    std::ranges::for_each(faces, [&](uint32_t face) {
        const Triangle t = mesh.getTriangleFromFaceIndex(face);
        box.extend(t.v1);
        box.extend(t.v2);
        box.extend(t.v3);
    });
    return box;
}

bool isLeaf(const std::vector<BVH::Node>& nodes, size_t i)
{
    return 2 * i + 2 >= nodes.size() || nodes[2 * i + 1].facesEnd == 0 || nodes[2 * i + 2].facesEnd == 0;
}

bool worthOpening(const std::vector<BVH::Node>& nodes, size_t i, const IntersectionRay& ray)
{
    if (!intersect(nodes[i].bounds, ray))
        return false;
    return isLeaf(nodes, i) || intersect(nodes[2 * i + 1].bounds, ray) || intersect(nodes[2 * i + 2].bounds, ray);
}

}  // namespace

void BVH::construct(const Mesh& mesh)
{
    const uint32_t numFaces = static_cast<uint32_t>(std::ranges::size(mesh.getFaces()));
    faceIndices.resize(numFaces);
    std::ranges::generate(faceIndices, [next = 0u]() mutable { return next++; });
    nodes.assign(1, Node{mesh.getBounds(), 0, numFaces});

    for (uint32_t depth = 0; depth < maxDepth; ++depth) {
        const size_t first = (size_t{1} << depth) - 1;
        const size_t last = std::min(2 * first + 1, nodes.size());
        for (size_t i = first; i < last; ++i) {
            const Node node = nodes[i];
            if (node.facesEnd <= node.facesBegin + numFacesPerLeaf)
                continue;
            const auto faces = getFaceIndices(node);
            split(mesh, faces, node.bounds);
            const uint32_t middle = static_cast<uint32_t>(faces.size() / 2);
            if (nodes.size() < 2 * i + 3)
                nodes.resize(2 * i + 3);
            nodes[2 * i + 1] = {boundsOf(mesh, faces.first(faces.size() / 2)), node.facesBegin, middle};
            nodes[2 * i + 2] = {boundsOf(mesh, faces.subspan(faces.size() / 2)), middle, node.facesEnd};
        }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    std::vector<size_t> current, next;
    if (!nodes.empty())
        current.push_back(0);
    for (; !current.empty(); current.swap(next), next.clear())  // level by level
        for (size_t i : current) {
            if (!intersect(nodes[i].bounds, ray))
                continue;
            if (2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd != 0) {
                next.push_back(2 * i + 1);
                next.push_back(2 * i + 2);
            } else
                for (uint32_t face : bvh.getFaceIndices(nodes[i])) {
                    const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
                    if (hit.t < best.t)
                        best = hit;
                }
        }
    return best;
}
