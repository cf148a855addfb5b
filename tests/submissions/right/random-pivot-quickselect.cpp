// right: quickselect with random pivots from a random_device, so every run partitions differently; slab distances as std::optional
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"

#include <optional>
#include <random>
#include <utility>

namespace {

/// Hoare's selection with a random pivot: expected O(n), whatever the input looks like.
template <typename Iterator, typename Less, typename Generator>
void selectNth(Iterator first, Iterator nth, Iterator last, Less less, Generator& random)
{
    while (last - first > 1) {
        const auto size = last - first;
        std::uniform_int_distribution<std::ptrdiff_t> any(0, size - 1);
        const auto pivot = *(first + any(random));
        // three-way partition (Dijkstra): smaller | equal | larger
        Iterator smaller = first, current = first, larger = last;
        while (current != larger) {
            if (less(*current, pivot))
                std::iter_swap(smaller++, current++);
            else if (less(pivot, *current))
                std::iter_swap(current, --larger);
            else
                ++current;
        }
        if (nth < smaller)
            last = smaller;
        else if (nth >= larger)
            first = larger;
        else
            return;
    }
}

struct Slab {
    float enter;
    float leave;
};

[[nodiscard]] std::optional<Slab> clip(const AABB& box, const IntersectionRay& ray, float closest)
{
    Slab slab{ray.t_min, std::min(ray.t_max, closest)};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float a = (box.min[axis] - ray.origin[axis]) * ray.inv_direction[axis];
        const float b = (box.max[axis] - ray.origin[axis]) * ray.inv_direction[axis];
        if (std::isnan(a) || std::isnan(b))
            continue; // 0 * infinity: the ray runs in the plane of a side, which is no reason to miss
        const float far = std::max(a, b);
        slab.enter = std::max(slab.enter, std::min(a, b));
        slab.leave = std::min(slab.leave, far + std::abs(far) * 1e-6f);
    }
    if (slab.enter > slab.leave)
        return std::nullopt;
    return slab;
}

} // namespace

void BVH::construct(const Mesh& mesh)
{
    std::mt19937 random{std::random_device{}()};

    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.assign(1, Node{mesh.getBounds(), 0, numFaces});

    struct Task {
        size_t node;
        uint32_t depth;
    };
    std::vector<Task> tasks{{0, 0}};
    while (!tasks.empty()) {
        const Task task = tasks.back();
        tasks.pop_back();
        const Node parent = nodes[task.node];
        const uint32_t count = parent.facesEnd - parent.facesBegin;
        if (count <= numFacesPerLeaf || task.depth == maxDepth)
            continue;

        const uint8_t axis = parent.bounds.extents().maxDimension();
        const auto center = [&](uint32_t face) {
            const Triangle triangle = mesh.getTriangleFromFaceIndex(face);
            return (triangle.v1[axis] + triangle.v2[axis] + triangle.v3[axis]) / 3.f;
        };
        const auto faces = getFaceIndices(parent);
        const uint32_t half = count / 2;
        selectNth(faces.begin(), faces.begin() + half, faces.end(),
                  [&](uint32_t a, uint32_t b) { return center(a) < center(b); }, random);

        const size_t left = 2 * task.node + 1;
        if (nodes.size() < left + 2)
            nodes.resize(left + 2);
        const uint32_t cuts[] = {parent.facesBegin, parent.facesBegin + half, parent.facesEnd};
        for (size_t child = 0; child < 2; ++child) {
            Node node{{}, cuts[child], cuts[child + 1]};
            for (const uint32_t face : getFaceIndices(node)) {
                const Triangle triangle = mesh.getTriangleFromFaceIndex(face);
                for (const Point3D& corner : {triangle.v1, triangle.v2, triangle.v3})
                    node.bounds.extend(corner);
            }
            nodes[left + child] = node;
            tasks.push_back({left + child, task.depth + 1});
        }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    Intersection closest;
    if (nodes.empty())
        return closest;

    std::array<std::pair<size_t, float>, 2 * BVH::maxDepth + 2> stack;
    size_t top = 0;
    if (const auto slab = clip(nodes[0].bounds, ray, infinity))
        stack[top++] = {0, slab->enter};
    while (top > 0) {
        const auto [index, enter] = stack[--top];
        if (enter > closest.t)
            continue; // something nearer was found since
        const size_t left = 2 * index + 1, right = left + 1;
        if (right >= nodes.size() || nodes[left].facesEnd == 0) {
            for (const uint32_t face : bvh.getFaceIndices(nodes[index]))
                if (const auto hit = intersect(mesh.getTriangleFromFaceIndex(face), ray); hit && hit.t < closest.t)
                    closest = hit;
            continue;
        }
        const auto a = clip(nodes[left].bounds, ray, closest.t);
        const auto b = clip(nodes[right].bounds, ray, closest.t);
        if (a && b) {
            const bool swap = b->enter < a->enter;
            stack[top++] = swap ? std::pair{left, a->enter} : std::pair{right, b->enter};
            stack[top++] = swap ? std::pair{right, b->enter} : std::pair{left, a->enter};
        } else if (a) {
            stack[top++] = {left, a->enter};
        } else if (b) {
            stack[top++] = {right, b->enter};
        }
    }
    return closest;
}
