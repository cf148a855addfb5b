// right: templates and static constexpr tables; the comparator is chosen from a table by axis; a visitor walks the tree
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <array>
#include <optional>

namespace detail {

template <size_t Axis>
bool centerLess(const Mesh& mesh, uint32_t a, uint32_t b)
{
    constexpr auto sum = [](const Triangle& t) { return t.v1[Axis] + t.v2[Axis] + t.v3[Axis]; };
    return sum(mesh.getTriangleFromFaceIndex(a)) < sum(mesh.getTriangleFromFaceIndex(b));
}

using Less = bool (*)(const Mesh&, uint32_t, uint32_t);
static constexpr std::array<Less, 3> less{centerLess<0>, centerLess<1>, centerLess<2>};

template <typename OnLeaf>
void walk(const BVH& bvh, const IntersectionRay& ray, OnLeaf&& onLeaf)
{
    const auto& nodes = bvh.getNodes();
    std::optional<size_t> at;
    if (!nodes.empty())
        at = 0;
    while (at) {
        size_t i = *at;
        if (intersect(nodes[i].bounds, ray)) {
            if (2 * i + 2 < nodes.size() && nodes[2 * i + 2].facesEnd != 0) {
                at = 2 * i + 2;  // right before left
                continue;
            }
            onLeaf(nodes[i]);
        }
        while (i % 2 == 1)  // a left child is the last of its parent
            i = (i - 1) / 2;
        at = i == 0 ? std::nullopt : std::optional(i - 1);
    }
}

}  // namespace detail

void BVH::construct(const Mesh& mesh)
{
    const auto n = static_cast<uint32_t>(mesh.getFaces().size());
    *this = BVH{};
    faceIndices.resize(n);
    std::generate(faceIndices.begin(), faceIndices.end(), [i = 0u]() mutable { return i++; });
    nodes.push_back({mesh.getBounds(), 0, n});

    for (uint32_t i = 0; i < nodes.size(); ++i) {
        const auto [bounds, begin, end] = nodes[i];
        if (end - begin <= numFacesPerLeaf || std::bit_width(i + 1) > int(maxDepth))
            continue;
        const auto less = detail::less[bounds.extents().maxDimension()];
        const uint32_t mid = begin + (end - begin) / 2;
        const auto it = faceIndices.begin();
        std::nth_element(it + begin, it + mid, it + end, [&mesh, less](uint32_t a, uint32_t b) { return less(mesh, a, b); });
        if (nodes.size() < 2 * i + 3)
            nodes.resize(2 * i + 3);
        for (const auto& [slot, from, to] : {std::array{2 * i + 1, begin, mid}, std::array{2 * i + 2, mid, end}}) {
            Node& child = nodes[slot] = Node{{}, from, to};
            for (const uint32_t face : getFaceIndices(child)) {
                const Triangle t = mesh.getTriangleFromFaceIndex(face);
                for (const Point3D& corner : {t.v1, t.v2, t.v3})
                    child.bounds.extend(corner);
            }
        }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    detail::walk(mesh.getBVH(), ray, [&](const BVH::Node& leaf) {
        for (const uint32_t face : mesh.getBVH().getFaceIndices(leaf)) {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
            if (hit.t < best.t)
                best = hit;
        }
    });
    return best;
}
