// right: every face is ranked once per axis (ties by index), then ranks decide the medians; parallel execution policies
#include <execution>
#include <memory_resource>
#include <optional>
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

using Ranks = std::array<std::vector<uint32_t>, 3>;

static Ranks rankAll(const Mesh& mesh)
{
    const uint32_t n = static_cast<uint32_t>(mesh.getFaces().size());
    Ranks ranks;
    std::vector<uint32_t> order(n);
    std::vector<float> centre(n);
    for (int axis : {0, 1, 2}) {
        std::iota(order.begin(), order.end(), 0u);
        std::transform(std::execution::par_unseq, order.begin(), order.end(), centre.begin(), [&mesh, axis](uint32_t f) {
            const Triangle t = mesh.getTriangleFromFaceIndex(f);
            return t.v1[axis] + t.v2[axis] + t.v3[axis];
        });
        std::sort(std::execution::par, order.begin(), order.end(), [&centre](uint32_t a, uint32_t b) {
            return centre[a] != centre[b] ? centre[a] < centre[b] : a < b;
        });
        ranks[axis].resize(n);
        for (uint32_t r = 0; r < n; ++r)
            ranks[axis][order[r]] = r;
    }
    return ranks;
}

void BVH::construct(const Mesh& mesh)
{
    const Ranks ranks = rankAll(mesh);
    const uint32_t n = uint32_t(ranks[0].size());
    faceIndices.resize(n);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);

    std::vector<std::optional<Node>> slots{Node{mesh.getBounds(), 0, n}};
    const auto isSplit = [&](size_t i, uint32_t depth) {
        return slots[i] && depth < maxDepth && slots[i]->facesEnd - slots[i]->facesBegin > numFacesPerLeaf;
    };
    for (uint32_t depth = 0; slots.size() >> depth; ++depth)
        for (size_t i = (1ull << depth) - 1; i < (2ull << depth) - 1 && i < slots.size(); ++i) {
            if (!isSplit(i, depth))
                continue;
            const Node node = *slots[i];
            const auto& rank = ranks[node.bounds.extents().maxDimension()];
            const uint32_t middle = (node.facesBegin + node.facesEnd + 1) / 2;
            std::nth_element(faceIndices.begin() + node.facesBegin, faceIndices.begin() + middle, faceIndices.begin() + node.facesEnd,
                             [&rank](uint32_t a, uint32_t b) { return rank[a] < rank[b]; });
            slots.resize(std::max(slots.size(), (size_t(4) << depth) - 1)); // whole levels
            const auto box = [&](uint32_t from, uint32_t to) {
                return std::transform_reduce(
                    std::execution::unseq, faceIndices.begin() + from, faceIndices.begin() + to, AABB{},
                    [](AABB a, const AABB& b) { a.extend(b); return a; },
                    [&mesh](uint32_t f) {
                        const auto t = mesh.getTriangleFromFaceIndex(f);
                        return AABB{min(t.v1, min(t.v2, t.v3)), max(t.v1, max(t.v2, t.v3))};
                    });
            };
            slots[2 * i + 1].emplace(Node{box(node.facesBegin, middle), node.facesBegin, middle});
            slots[2 * i + 2].emplace(Node{box(middle, node.facesEnd), middle, node.facesEnd});
        }
    nodes.clear();
    std::transform(slots.begin(), slots.end(), std::back_inserter(nodes), [](const auto& slot) { return slot.value_or(Node{}); });
}

// an index into the nodes, and which way round its children are visited
struct Cursor {
    const std::vector<BVH::Node>* nodes;
    size_t index;
    Cursor left() const { return {nodes, index * 2 + 1}; }
    Cursor right() const { return {nodes, index * 2 + 2}; }
    explicit operator bool() const { return index < nodes->size() && (*nodes)[index].facesEnd != 0; }
    const BVH::Node& operator*() const { return (*nodes)[index]; }
    const BVH::Node* operator->() const { return &**this; }
};

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    std::byte memory[4096];
    std::pmr::monotonic_buffer_resource arena(memory, sizeof memory);
    std::pmr::vector<Cursor> waiting(&arena);
    waiting.reserve(64);
    Intersection best;
    if (const Cursor root{&mesh.getBVH().getNodes(), 0}; root && intersect(root->bounds, ray))
        waiting.push_back(root);
    while (!waiting.empty()) {
        const Cursor at = waiting.back();
        waiting.pop_back();
        if (!at.left() || !at.right()) {
            for (uint32_t f : mesh.getBVH().getFaceIndices(*at))
                if (Intersection hit = intersect(mesh.getTriangleFromFaceIndex(f), ray); hit && hit.t < best.t)
                    std::swap(best, hit);
            continue;
        }
        for (const Cursor& child : {at.left(), at.right()})
            if (intersect(child->bounds, ray))
                waiting.push_back(child);
    }
    return best;
}
