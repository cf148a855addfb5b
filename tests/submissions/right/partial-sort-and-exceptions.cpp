// right: std::partial_sort for the lower half; intersect asks nodes.at(), and what it throws and catches means "leaf"
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <stdexcept>

void BVH::construct(const Mesh& mesh)
{
    const uint32_t numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices = std::vector<uint32_t>(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);
    nodes = std::vector<Node>{Node{mesh.getBounds(), 0, numFaces}};

    std::vector<Point3D> triangleCenters;
    triangleCenters.reserve(numFaces);
    for (const TriangleIndices& face : mesh.getFaces()) {
        const Triangle triangle = mesh.getTriangleFromFace(face);
        triangleCenters.emplace_back((triangle.v3 + triangle.v2 + triangle.v1) / 3.0f);
    }

    for (uint32_t level = 0, index = 0; level < maxDepth; ++level) {
        for (uint32_t k = 0; k < (1u << level); ++k, ++index) {
            if (index >= nodes.size())
                return;
            const Node node = nodes.at(index);
            const auto faces = getFaceIndices(node);
            if (faces.size() <= numFacesPerLeaf)
                continue;
            const uint8_t dimension = node.bounds.extents().maxDimension();
            const size_t half = (faces.size() + 1) / 2;
            std::partial_sort(faces.begin(), faces.begin() + half, faces.end(), [&](uint32_t lhs, uint32_t rhs) {
                return triangleCenters.at(lhs)[dimension] < triangleCenters.at(rhs)[dimension];
            });

            const auto makeLeaf = [&](uint32_t begin, uint32_t end) {
                Node leaf{AABB{}, begin, end};
                for (const uint32_t faceIndex : getFaceIndices(leaf)) {
                    const Triangle triangle = mesh.getTriangleFromFaceIndex(faceIndex);
                    leaf.bounds.extend(triangle.v1);
                    leaf.bounds.extend(triangle.v2);
                    leaf.bounds.extend(triangle.v3);
                }
                return leaf;
            };
            const auto middle = node.facesBegin + static_cast<uint32_t>(half);
            if (2 * index + 2 >= nodes.size())
                nodes.resize(2 * index + 3);
            nodes.at(2 * index + 1) = makeLeaf(node.facesBegin, middle);
            nodes.at(2 * index + 2) = makeLeaf(middle, node.facesEnd);
        }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection result;
    const BVH& bvh = mesh.getBVH();
    if (!bvh.isConstructed())
        return result;
    std::vector<size_t> indices = {0};
    while (!indices.empty()) {
        const size_t index = indices.back();
        indices.pop_back();
        const BVH::Node& node = bvh.getNodes().at(index);
        if (!intersect(node.bounds, ray))
            continue;
        try {
            const BVH::Node& left = bvh.getNodes().at(2 * index + 1);
            const BVH::Node& right = bvh.getNodes().at(2 * index + 2);
            if (left.facesEnd == 0 || right.facesEnd == 0)
                throw std::out_of_range("empty children");
            indices.push_back(2 * index + 2);
            indices.push_back(2 * index + 1);
        } catch (const std::out_of_range&) {
            for (const uint32_t faceIndex : bvh.getFaceIndices(node)) {
                const Intersection intersection = intersect(mesh.getTriangleFromFaceIndex(faceIndex), ray);
                if (intersection.t < result.t)
                    result = intersection;
            }
        }
    }
    return result;
}
