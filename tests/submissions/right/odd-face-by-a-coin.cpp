// right: a coin decides on which side the extra face of an odd number goes, so that no side is preferred
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <random>

namespace {

std::minstd_rand generator{std::random_device{}()};

uint32_t zeroOrOne()
{
    return std::uniform_int_distribution<uint32_t>(0, 1)(generator);
}

AABB boundsOf(const Mesh& mesh, std::span<const uint32_t> faces)
{
    AABB box;
    for (const uint32_t face : faces) {
        const Triangle t = mesh.getTriangleFromFaceIndex(face);
        box.extend(t.v1);
        box.extend(t.v2);
        box.extend(t.v3);
    }
    return box;
}

} // namespace

void BVH::construct(const Mesh& mesh)
{
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.assign(1, Node{mesh.getBounds(), 0, numFaces});

    std::vector<Point3D> centers(numFaces);
    for (uint32_t f = 0; f < numFaces; ++f) {
        const Triangle t = mesh.getTriangleFromFaceIndex(f);
        centers[f] = (t.v1 + t.v2 + t.v3) / 3.0f;
    }
    std::queue<std::pair<size_t, uint32_t>> todo;
    todo.emplace(0, 0);
    while (!todo.empty()) {
        const auto [i, depth] = todo.front();
        todo.pop();
        const Node node = nodes[i];
        const uint32_t count = node.facesEnd - node.facesBegin;
        if (count <= numFacesPerLeaf || depth >= maxDepth)
            continue;
        // An even number is halved exactly, whatever the coin says.
        const uint32_t half = (count + zeroOrOne()) / 2;
        const uint8_t axis = node.bounds.extents().maxDimension();
        const std::span<uint32_t> faces = getFaceIndices(node);
        std::nth_element(faces.begin(), faces.begin() + half, faces.end(),
                         [&](uint32_t a, uint32_t b) { return centers[a][axis] < centers[b][axis]; });
        nodes.resize(std::max(nodes.size(), 2 * i + 3));
        const uint32_t middle = node.facesBegin + half;
        nodes[2 * i + 1] = Node{boundsOf(mesh, faces.first(half)), node.facesBegin, middle};
        nodes[2 * i + 2] = Node{boundsOf(mesh, faces.subspan(half)), middle, node.facesEnd};
        todo.emplace(2 * i + 1, depth + 1);
        todo.emplace(2 * i + 2, depth + 1);
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    Intersection closest;
    IntersectionRay rest{ray};
    std::vector<size_t> stack;
    if (!nodes.empty())
        stack.push_back(0);
    while (!stack.empty()) {
        const size_t i = stack.back();
        stack.pop_back();
        if (!intersect(nodes[i].bounds, rest))
            continue;
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd != 0) {
            stack.push_back(2 * i + 2);
            stack.push_back(2 * i + 1);
            continue;
        }
        for (const uint32_t face : bvh.getFaceIndices(nodes[i])) {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), rest);
            if (hit) {
                closest = hit;
                rest.t_max = hit.t;
            }
        }
    }
    return closest;
}
