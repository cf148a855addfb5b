// right: std::pmr containers in arenas, on the stack in intersect; a namespace of its own that is called ex03, too
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <cstddef>
#include <deque>
#include <memory_resource>

namespace ex03 {
namespace {

constexpr auto left(std::size_t i) noexcept { return (i << 1) | 1; }
constexpr auto right(std::size_t i) noexcept { return (i + 1) << 1; }
constexpr auto depthOf(std::size_t i) noexcept { return std::bit_width(i + 1) - 1; }
static_assert(left(0) == 1 && right(0) == 2 && left(2) == 5 && right(2) == 6 && depthOf(6) == 2);

struct Record {
    Point3D center;
    AABB box;
};

} // namespace
} // namespace ex03

void BVH::construct(const Mesh& mesh)
{
    std::pmr::monotonic_buffer_resource arena{1 << 16};
    std::pmr::vector<ex03::Record> records{&arena};
    const std::size_t numFaces = mesh.getFaces().size();
    records.reserve(numFaces);
    for (std::size_t f = 0; f < numFaces; ++f) {
        const Triangle t = mesh.getTriangleFromFaceIndex(f);
        ex03::Record& record = records.emplace_back();
        for (const Point3D* corner : {&t.v1, &t.v2, &t.v3})
            record.box.extend(*corner);
        record.center = (t.v1 + t.v2 + t.v3) / 3;
    }

    std::vector<uint32_t>{}.swap(faceIndices);
    std::vector<Node>{}.swap(nodes);
    faceIndices.resize(numFaces);
    std::generate(faceIndices.begin(), faceIndices.end(), [f = 0u]() mutable { return f++; });
    nodes.emplace_back(Node{mesh.getBounds(), 0u, uint32_t(numFaces)});

    std::pmr::deque<std::size_t> open{&arena};
    open.push_back(0);
    for (; !open.empty(); open.pop_front()) {
        const std::size_t i = open.front();
        const Node node = nodes[i];
        const auto faces = getFaceIndices(node);
        if (faces.size() <= numFacesPerLeaf || std::size_t(ex03::depthOf(i)) >= maxDepth)
            continue;
        const auto axis = node.bounds.extents().maxDimension();
        const auto half = faces.size() / 2;
        std::nth_element(faces.begin(), faces.begin() + half, faces.end(),
                         [&](auto a, auto b) { return records[a].center[axis] < records[b].center[axis]; });
        const auto fuse = [&](AABB box, uint32_t face) {
            box.extend(records[face].box);
            return box;
        };
        if (nodes.size() <= ex03::right(i))
            nodes.resize(ex03::right(i) + 1);
        const auto cut = node.facesBegin + uint32_t(half);
        nodes[ex03::left(i)] = {std::accumulate(faces.begin(), faces.begin() + half, AABB{}, fuse), node.facesBegin, cut};
        nodes[ex03::right(i)] = {std::accumulate(faces.begin() + half, faces.end(), AABB{}, fuse), cut, node.facesEnd};
        open.push_back(ex03::left(i));
        open.push_back(ex03::right(i));
    }
    nodes.shrink_to_fit();
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    std::array<std::byte, 4096> buffer;
    std::pmr::monotonic_buffer_resource arena{buffer.data(), buffer.size()};
    std::pmr::vector<std::size_t> level{&arena}, next{&arena};

    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    Intersection closest;
    if (!nodes.empty() && intersect(nodes[0].bounds, ray))
        level.push_back(0);
    while (!level.empty()) {
        for (const std::size_t i : level) {
            const bool inner = ex03::right(i) < nodes.size() && nodes[ex03::right(i)].facesEnd != 0;
            if (inner) {
                if (intersect(nodes[ex03::left(i)].bounds, ray))
                    next.push_back(ex03::left(i));
                if (intersect(nodes[ex03::right(i)].bounds, ray))
                    next.push_back(ex03::right(i));
            } else {
                for (const uint32_t face : bvh.getFaceIndices(nodes[i]))
                    if (const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray); hit.t < closest.t)
                        closest = hit;
            }
        }
        level.swap(next);
        next.clear();
    }
    return closest;
}
