// right: a chatbot's style: numbered doc comments, constexpr k-constants, noexcept, [[nodiscard]], a "robust" fallback for everything
/**
 * @file   exercise03.cpp
 * @brief  Construction and traversal of a Bounding Volume Hierarchy (BVH).
 *
 * Key design decisions:
 *   1. **Iterative construction** using an explicit work queue (no recursion).
 *   2. **Implicit binary heap layout**: children of node i live at 2i+1 and 2i+2.
 *   3. **Front-to-back traversal** with early termination.
 */
#include "aabb.h"
#include "bvh.h"
#include "common.h"
#include "intersection.h"
#include "mesh.h"
#include "point3d.h"
#include "ray.h"
#include "triangle.h"

#include <concepts>
#include <limits>
#include <optional>
#include <type_traits>

namespace detail {

/// Index of the root node.
inline constexpr std::size_t kRootIndex = 0;

/// Relative safety margin for comparing box entries with hits.
inline constexpr float kSafetyMargin = 4.0f * std::numeric_limits<float>::epsilon();

/// Capacity of the traversal stack; one entry per level is enough.
inline constexpr std::size_t kStackCapacity = 64;

template <typename T>
concept UnsignedIndex = std::unsigned_integral<T>;

[[nodiscard]] constexpr auto leftChild(UnsignedIndex auto parent) noexcept { return 2 * parent + 1; }
[[nodiscard]] constexpr auto rightChild(UnsignedIndex auto parent) noexcept { return 2 * parent + 2; }

/// Computes the centroid of a triangle.
[[nodiscard]] inline Point3D triangleCenter(const Triangle& triangle) noexcept
{
    constexpr float kOneThird = 1.0f / 3.0f;
    return (triangle.v1 + triangle.v2 + triangle.v3) * kOneThird;
}

/// Computes the bounding box of all given faces (a C++17 fold expression extends by the corners).
template <typename... Corners>
void extendAll(AABB& box, const Corners&... corners) noexcept
{
    (box.extend(corners), ...);
}

[[nodiscard]] inline AABB computeBounds(const Mesh& mesh, std::span<const uint32_t> faces)
{
    AABB bounds{};
    for (const auto face : faces) {
        const auto triangle = mesh.getTriangleFromFaceIndex(face);
        extendAll(bounds, triangle.v1, triangle.v2, triangle.v3);
    }
    return bounds;
}

/// Determines whether the node at `index` is a leaf, as specified on the exercise sheet.
[[nodiscard]] inline bool isLeaf(const std::vector<BVH::Node>& nodes, std::size_t index) noexcept
{
    const auto left = leftChild(index);
    const auto right = rightChild(index);
    return left >= nodes.size() || right >= nodes.size() || nodes[left].facesEnd == 0 || nodes[right].facesEnd == 0;
}

/// Returns the parametric distance at which the ray enters the box, if it does at all.
[[nodiscard]] inline std::optional<float> entryDistance(const AABB& box, const IntersectionRay& ray) noexcept
{
    // Step 1: let the provided (robust) slab test decide.
    if (!intersect(box, ray)) {
        return std::nullopt;
    }
    // Step 2: compute a conservative lower bound of the entry; ignore undefined slabs (NaN).
    float entry = ray.t_min;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float t0 = (box.min[axis] - ray.origin[axis]) * ray.inv_direction[axis];
        const float t1 = (box.max[axis] - ray.origin[axis]) * ray.inv_direction[axis];
        const float near = std::min(t0, t1);
        if (std::isfinite(t0) && std::isfinite(t1) && near > entry) {
            entry = near;
        }
    }
    return entry - std::abs(entry) * kSafetyMargin;
}

/// A pending traversal step.
struct TraversalEntry {
    std::size_t nodeIndex{kRootIndex};
    float entry{0.0f};
};
static_assert(std::is_trivially_copyable_v<TraversalEntry>);

/// Fixed-capacity LIFO stack that falls back to the heap if it ever overflows.
class TraversalStack {
public:
    void push(const TraversalEntry& entry)
    {
        if (size_ < kStackCapacity) {
            entries_[size_++] = entry;
        } else {
            overflow_.push_back(entry);
        }
    }

    [[nodiscard]] std::optional<TraversalEntry> pop()
    {
        if (!overflow_.empty()) {
            const auto entry = overflow_.back();
            overflow_.pop_back();
            return entry;
        }
        if (size_ == 0) {
            return std::nullopt;
        }
        return entries_[--size_];
    }

private:
    std::array<TraversalEntry, kStackCapacity> entries_{};
    std::size_t size_{0};
    std::vector<TraversalEntry> overflow_{};
};

} // namespace detail

/**
 * @brief Builds the BVH using the median-split heuristic.
 *
 * Time complexity:  O(n log n) on average.
 * Space complexity: O(n).
 */
void BVH::construct(const Mesh& mesh)
{
    // ---------------------------------------------------------------------
    // 1. Reset any previous state.
    // ---------------------------------------------------------------------
    nodes.clear();
    faceIndices.clear();

    // ---------------------------------------------------------------------
    // 2. Handle the degenerate case of an empty mesh.
    // ---------------------------------------------------------------------
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    if (numFaces == 0) {
        return;
    }

    // ---------------------------------------------------------------------
    // 3. Precompute all centroids and initialise the root node.
    // ---------------------------------------------------------------------
    std::vector<Point3D> centroids;
    centroids.reserve(numFaces);
    for (uint32_t face = 0; face < numFaces; ++face) {
        centroids.push_back(detail::triangleCenter(mesh.getTriangleFromFaceIndex(face)));
    }
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.reserve(2 * static_cast<std::size_t>(roundUpPowerOfTwo(numFaces)));
    nodes.push_back(Node{mesh.getBounds(), 0u, numFaces});

    // ---------------------------------------------------------------------
    // 4. Iteratively subdivide nodes in breadth-first order.
    // ---------------------------------------------------------------------
    struct WorkItem {
        std::size_t nodeIndex;
        uint32_t depth;
    };
    std::queue<WorkItem> workQueue;
    workQueue.push({detail::kRootIndex, 0u});
    while (!workQueue.empty()) {
        const auto [nodeIndex, depth] = workQueue.front();
        workQueue.pop();

        // IMPORTANT: copy the node, because resizing invalidates references!
        const Node node = nodes[nodeIndex];
        if (node.facesEnd - node.facesBegin <= numFacesPerLeaf || depth >= maxDepth) {
            continue;
        }

        // 4a. Choose the axis with the largest extent.
        const auto axis = node.bounds.extents().maxDimension();

        // 4b. Partition around the median centroid (ties broken by index for determinism).
        auto faces = getFaceIndices(node);
        const auto half = faces.size() / 2;
        std::ranges::nth_element(faces, faces.begin() + static_cast<std::ptrdiff_t>(half),
                                 [&centroids, axis](const uint32_t lhs, const uint32_t rhs) noexcept {
                                     const float a = centroids[lhs][axis];
                                     const float b = centroids[rhs][axis];
                                     return a != b ? a < b : lhs < rhs;
                                 });

        // 4c. Create both children.
        const auto left = detail::leftChild(nodeIndex);
        const auto right = detail::rightChild(nodeIndex);
        if (right >= nodes.size()) {
            nodes.resize(right + 1);
        }
        const auto middle = node.facesBegin + static_cast<uint32_t>(half);
        nodes[left] = Node{detail::computeBounds(mesh, faces.first(half)), node.facesBegin, middle};
        nodes[right] = Node{detail::computeBounds(mesh, faces.subspan(half)), middle, node.facesEnd};

        // 4d. Schedule them.
        workQueue.push({left, depth + 1});
        workQueue.push({right, depth + 1});
    }
}

/**
 * @brief Finds the closest intersection between a ray and a mesh.
 */
Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection closest{};
    const auto& bvh = mesh.getBVH();
    if (!bvh.isConstructed()) {
        // Fallback: brute force. Should never happen, but better safe than sorry.
        for (std::size_t face = 0; face < mesh.getFaces().size(); ++face) {
            const auto hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
            if (hit.t < closest.t) {
                closest = hit;
            }
        }
        return closest;
    }

    const auto& nodes = bvh.getNodes();
    detail::TraversalStack stack;
    if (const auto entry = detail::entryDistance(nodes[detail::kRootIndex].bounds, ray)) {
        stack.push({detail::kRootIndex, *entry});
    }
    while (const auto current = stack.pop()) {
        if (current->entry > closest.t) {
            continue; // Early termination: a closer hit is already known.
        }
        const auto index = current->nodeIndex;
        if (detail::isLeaf(nodes, index)) {
            for (const auto face : bvh.getFaceIndices(nodes[index])) {
                const auto hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
                if (hit && hit.t < closest.t) {
                    closest = hit;
                }
            }
            continue;
        }
        const auto left = detail::leftChild(index);
        const auto right = detail::rightChild(index);
        const auto leftEntry = detail::entryDistance(nodes[left].bounds, ray);
        const auto rightEntry = detail::entryDistance(nodes[right].bounds, ray);
        if (leftEntry && rightEntry) {
            const bool leftFirst = *leftEntry <= *rightEntry;
            stack.push(leftFirst ? detail::TraversalEntry{right, *rightEntry} : detail::TraversalEntry{left, *leftEntry});
            stack.push(leftFirst ? detail::TraversalEntry{left, *leftEntry} : detail::TraversalEntry{right, *rightEntry});
        } else if (leftEntry) {
            stack.push({left, *leftEntry});
        } else if (rightEntry) {
            stack.push({right, *rightEntry});
        }
    }
    return closest;
}
