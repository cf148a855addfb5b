// right: C++20 coroutines: one generator yields the nodes to split, another the leaves along the ray
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <coroutine>
#include <exception>

namespace {

template <typename T>
class Generator {
public:
    struct promise_type {
        T value{};
        Generator get_return_object() { return Generator{Handle::from_promise(*this)}; }
        std::suspend_always initial_suspend() noexcept { return {}; }
        std::suspend_always final_suspend() noexcept { return {}; }
        std::suspend_always yield_value(T next) noexcept
        {
            value = next;
            return {};
        }
        void return_void() noexcept {}
        void unhandled_exception() { std::terminate(); }
    };
    using Handle = std::coroutine_handle<promise_type>;

    struct Sentinel {};
    struct Iterator {
        Handle handle;
        T operator*() const { return handle.promise().value; }
        Iterator& operator++()
        {
            handle.resume();
            return *this;
        }
        bool operator!=(Sentinel) const { return !handle.done(); }
    };

    explicit Generator(Handle handle) : handle(handle) {}
    Generator(const Generator&) = delete;
    Generator& operator=(const Generator&) = delete;
    ~Generator() { handle.destroy(); }

    Iterator begin()
    {
        handle.resume();
        return {handle};
    }
    Sentinel end() const { return {}; }

private:
    Handle handle;
};

/// Nodes in breadth-first order that have too many faces; looks at the vector while it grows.
Generator<size_t> nodesToSplit(const std::vector<BVH::Node>& nodes)
{
    for (uint32_t depth = 0; depth < BVH::maxDepth; ++depth) {
        const size_t first = (size_t{1} << depth) - 1;
        for (size_t i = first; i <= 2 * first && i < nodes.size(); ++i)
            if (nodes[i].facesEnd - nodes[i].facesBegin > BVH::numFacesPerLeaf)
                co_yield i;
    }
}

Generator<const BVH::Node*> leavesAlong(const std::vector<BVH::Node>& nodes, const IntersectionRay& ray)
{
    size_t stack[64];
    int top = 0;
    if (!nodes.empty())
        stack[top++] = 0;
    while (top > 0) {
        const size_t i = stack[--top];
        if (!intersect(nodes[i].bounds, ray))
            continue;
        const size_t left = 2 * i + 1;
        if (left >= nodes.size() || nodes[left].facesEnd == 0) {
            co_yield &nodes[i];
        } else {
            stack[top++] = left + 1;
            stack[top++] = left;
        }
    }
}

Point3D triangleCenter(const Mesh& mesh, uint32_t face)
{
    const Triangle t = mesh.getTriangleFromFaceIndex(face);
    return (t.v1 + t.v2 + t.v3) * (1.0f / 3.0f);
}

} // namespace

void BVH::construct(const Mesh& mesh)
{
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    nodes = {Node{mesh.getBounds(), 0, numFaces}};
    faceIndices.assign(numFaces, 0);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);

    for (const size_t i : nodesToSplit(nodes)) {
        const Node node = nodes[i];
        const auto faces = getFaceIndices(node);
        const auto half = faces.size() / 2;
        const auto axis = node.bounds.extents().maxDimension();
        std::nth_element(faces.begin(), faces.begin() + half, faces.end(), [&](uint32_t a, uint32_t b) {
            return triangleCenter(mesh, a)[axis] < triangleCenter(mesh, b)[axis];
        });
        nodes.resize(std::max(nodes.size(), 2 * i + 3));
        const uint32_t middle = node.facesBegin + static_cast<uint32_t>(half);
        nodes[2 * i + 1] = Node{AABB{}, node.facesBegin, middle};
        nodes[2 * i + 2] = Node{AABB{}, middle, node.facesEnd};
        for (Node* child : {&nodes[2 * i + 1], &nodes[2 * i + 2]})
            for (const uint32_t face : getFaceIndices(*child)) {
                const auto [v1, v2, v3] = mesh.getFaces()[face];
                for (const uint32_t v : {v1, v2, v3})
                    child->bounds.extend(mesh.getVertices()[v]);
            }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection closest;
    for (const BVH::Node* leaf : leavesAlong(mesh.getBVH().getNodes(), ray))
        for (const uint32_t face : mesh.getBVH().getFaceIndices(*leaf)) {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
            if (hit.t < closest.t)
                closest = hit;
        }
    return closest;
}
