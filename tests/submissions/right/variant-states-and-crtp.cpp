// right: CRTP, concepts, std::variant with std::visit for inner nodes and leaves, specialisations in namespace std, user-defined literals
#include "intersection.h"
#include "mesh.h"
#include "bvh.h"

#include <concepts>
#include <functional>
#include <ranges>
#include <type_traits>
#include <unordered_map>
#include <variant>

inline namespace literals_of_mine {
consteval size_t operator""_th(unsigned long long value) { return static_cast<size_t>(value); }
}

struct NodeId {
    size_t value = 0_th;
    constexpr NodeId operator<<(int) const { return {2 * value + 1}; }
    constexpr NodeId operator>>(int) const { return {2 * value + 2}; }
    constexpr auto operator<=>(const NodeId&) const = default;
};

template <>
struct std::hash<NodeId> {
    size_t operator()(NodeId id) const noexcept { return id.value * 0x9E3779B97F4A7C15ull; }
};

template <class... F>
struct overloaded : F... { using F::operator()...; };

struct Faces { uint32_t begin, end; constexpr uint32_t count() const { return end - begin; } };

template <typename T>
concept Centroid = requires(T c, uint32_t f, uint8_t axis) { { c(f, axis) } -> std::convertible_to<float>; };

template <class Derived>
class Subdivision {
  public:
    void run(Faces all, const AABB& bounds) {
        frontier.emplace(NodeId{}, std::pair{all, bounds});
        self().store(NodeId{}, all, bounds);
        for (unsigned depth = 0; depth < self().deepest() && !frontier.empty(); ++depth) {
            std::unordered_map<NodeId, std::pair<Faces, AABB>> children;
            for (const auto& [id, what] : frontier) {
                const auto& [faces, box] = what;
                if (faces.count() <= self().leafSize())
                    continue;
                const Faces left{faces.begin, self().divide(faces, box)}, right{left.end, faces.end};
                for (const auto& [child, part] : {std::pair{id << 1, left}, std::pair{id >> 1, right}}) {
                    const AABB bounds = self().measure(part);
                    self().store(child, part, bounds);
                    children.try_emplace(child, part, bounds);
                }
            }
            frontier = std::move(children);
        }
    }

  private:
    Derived& self() { return static_cast<Derived&>(*this); }
    std::unordered_map<NodeId, std::pair<Faces, AABB>> frontier;
};

template <Centroid C>
class MedianSplit : public Subdivision<MedianSplit<C>> {
  public:
    MedianSplit(const Mesh& m, std::vector<uint32_t>& o, C c, std::function<void(NodeId, Faces, const AABB&)> s)
        : mesh(m), order(o), centroid(std::move(c)), sink(std::move(s)) {}
    static constexpr unsigned deepest() { return BVH::maxDepth; }
    static constexpr unsigned leafSize() { return BVH::numFacesPerLeaf; }
    uint32_t divide(Faces faces, const AABB& box) {
        const uint8_t axis = box.extents().maxDimension();
        const uint32_t cut = faces.begin + faces.count() / 2;
        std::ranges::nth_element(order.begin() + faces.begin, order.begin() + cut, order.begin() + faces.end, std::ranges::less{},
                                 [&](uint32_t f) { return centroid(f, axis); });
        return cut;
    }
    AABB measure(Faces faces) const {
        AABB box;
        for (uint32_t f : order | std::views::drop(faces.begin) | std::views::take(faces.count())) {
            const auto& [a, b, c, ab, ac] = mesh.getTriangleFromFaceIndex(f);
            for (const auto& corner : {std::cref(a), std::cref(b), std::cref(c)})
                box.extend(corner.get());
        }
        return box;
    }
    void store(NodeId id, Faces faces, const AABB& box) { sink(id, faces, box); }

  private:
    const Mesh& mesh;
    std::vector<uint32_t>& order;
    C centroid;
    std::function<void(NodeId, Faces, const AABB&)> sink;
};

void BVH::construct(const Mesh& mesh)
{
    nodes.clear();
    const auto iota = std::views::iota(0u, static_cast<uint32_t>(mesh.getFaces().size()));
    faceIndices.assign(iota.begin(), iota.end());
    MedianSplit split{
        mesh, faceIndices,
        [&mesh](uint32_t f, uint8_t axis) {
            const Triangle t = mesh.getTriangleFromFaceIndex(f);
            return ((t.v1 + t.v2 + t.v3) * (1.f / 3.f))[axis];
        },
        [this](NodeId id, Faces faces, const AABB& box) {
            if (nodes.size() <= id.value)
                nodes.resize(id.value + 1); // the last one may be a left child for a while
            nodes[id.value] = {.bounds = box, .facesBegin = faces.begin, .facesEnd = faces.end};
        }};
    split.run({0, static_cast<uint32_t>(faceIndices.size())}, mesh.getBounds());
}

struct Inner { NodeId left, right; };
struct Leaf { std::span<const uint32_t> faces; };
using Kind = std::variant<std::monostate, Inner, Leaf>;

static Kind classify(const BVH& bvh, NodeId id, const IntersectionRay& ray)
{
    const auto& nodes = bvh.getNodes();
    if (id.value >= nodes.size() || !intersect(nodes[id.value].bounds, ray))
        return {};
    if ((id >> 1).value < nodes.size() && nodes[(id << 1).value].facesEnd != 0)
        return Inner{id << 1, id >> 1};
    return Leaf{bvh.getFaceIndices(nodes[id.value])};
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    std::queue<NodeId> open({NodeId{}});
    for (; !open.empty(); open.pop())
        std::visit(overloaded{[](std::monostate) {},
                              [&](const Inner& inner) { open.push(inner.left), open.push(inner.right); },
                              [&](const Leaf& leaf) {
                                  for (uint32_t f : leaf.faces)
                                      if (const auto hit = intersect(mesh.getTriangleFromFaceIndex(f), ray); hit && hit.t < best.t)
                                          best = hit;
                              }},
                   classify(mesh.getBVH(), open.front(), ray));
    return best;
}
