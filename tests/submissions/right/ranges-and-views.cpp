// right: ranges with projections, views, std::transform_reduce for the boxes; children sorted by distance with std::ranges::sort
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <functional>
#include <iterator>
#include <ranges>

namespace rng = std::ranges;
namespace views = std::views;

void BVH::construct(const Mesh& mesh) {
    const auto boxOf = [&mesh](const uint32_t face) -> AABB {
        const auto triangle = mesh.getTriangleFromFaceIndex(face);
        return {min(triangle.v1, min(triangle.v2, triangle.v3)), max(triangle.v1, max(triangle.v2, triangle.v3))};
    };
    const auto unite = [](AABB a, const AABB& b) -> AABB { return a.extend(b), a; };
    const auto nodeOf = [&](const uint32_t begin, const uint32_t end) -> Node {
        const auto faces = faceIndices | views::drop(begin) | views::take(end - begin);
        return {std::transform_reduce(rng::begin(faces), rng::end(faces), AABB{}, unite, boxOf), begin, end};
    };
    const auto isTooLarge = [](const Node& node) { return node.facesEnd - node.facesBegin > numFacesPerLeaf; };

    faceIndices.clear();
    rng::copy(views::iota(0u, static_cast<uint32_t>(mesh.getFaces().size())), std::back_inserter(faceIndices));
    nodes.assign({Node{mesh.getBounds(), 0, static_cast<uint32_t>(rng::size(faceIndices))}});

    for (const auto depth : views::iota(0u, +maxDepth)) {
        const auto first = (std::size_t{1} << depth) - 1;
        const auto level = views::iota(first, std::max(first, std::min(nodes.size(), 2 * first + 1)));
        for (const auto i : level | views::filter([&](const auto i) { return isTooLarge(nodes[i]); })) {
            const auto [bounds, begin, end] = nodes[i];
            const auto center = [&mesh, axis = bounds.extents().maxDimension()](const uint32_t face) {
                const auto triangle = mesh.getTriangleFromFaceIndex(face);
                return (triangle.v1[axis] + (triangle.v2[axis] + triangle.v3[axis])) / 3;
            };
            const auto middle = std::midpoint(begin, end);
            const auto faces = getFaceIndices(nodes[i]);
            rng::nth_element(faces, rng::next(faces.begin(), middle - begin), rng::less{}, center);
            nodes.resize(std::max(nodes.size(), 2 * i + 3));
            rng::transform(std::array{std::pair{begin, middle}, std::pair{middle, end}}, nodes.begin() + 2 * i + 1,
                           [&](const auto range) { return std::apply(nodeOf, range); });
        }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const auto& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    const auto isLeaf = [&](const std::size_t i) { return 2 * i + 2 >= nodes.size() || nodes[2 * i + 1].facesEnd == 0; };
    const auto distance = [&](const std::size_t i) { return dot(nodes[i].bounds.center() - ray.origin, ray.direction); };

    Intersection closest;
    std::vector<std::size_t> open(rng::empty(nodes) ? 0 : 1);
    while (!rng::empty(open)) {
        const auto i = open.back();
        open.pop_back();
        if (!intersect(nodes[i].bounds, ray)) continue;
        if (isLeaf(i)) {
            auto hits = bvh.getFaceIndices(nodes[i]) |
                        views::transform([&](const uint32_t face) { return intersect(mesh.getTriangleFromFaceIndex(face), ray); }) |
                        views::filter(&Intersection::operator bool);
            for (const Intersection hit : hits) closest = rng::min(closest, hit, {}, &Intersection::t);
            continue;
        }
        std::array children{2 * i + 1, 2 * i + 2};
        rng::sort(children, rng::greater{}, distance);
        rng::copy(children, std::back_inserter(open));
    }
    return closest;
}
