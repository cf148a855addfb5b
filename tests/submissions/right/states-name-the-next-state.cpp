// Two state machines whose states are functions that return the next state; a driver loop calls them, so no state ever calls another one.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <tuple>

/// A state is a function that does one step and says what comes next. Nothing means stop.
template <typename Machine> struct State {
    using Function = State (*)(Machine&);
    Function function{nullptr};
    constexpr State() = default;
    constexpr State(Function f) : function(f) {}
};

template <typename Machine> static void runUntilDone(State<Machine> state, Machine& machine) {
    while (state.function != nullptr) {
        state = state.function(machine);
    }
}

// --- building ---------------------------------------------------------------------------------

namespace build {

struct Machine {
    const Mesh& mesh;
    std::vector<BVH::Node>& nodes;
    std::vector<uint32_t>& faceIndices;
    std::vector<std::pair<size_t, uint32_t>> todo{};
    size_t index{0};
    uint32_t depth{0};
    uint32_t middle{0};
};
using S = State<Machine>;

S start(Machine&);
S fetch(Machine&);
S decide(Machine&);
S partition(Machine&);
S attachChildren(Machine&);
S stop(Machine&);

S start(Machine& m) {
    m.nodes.clear();
    m.faceIndices.clear();
    const auto numFaces = static_cast<uint32_t>(m.mesh.getFaces().size());
    while (m.faceIndices.size() < numFaces) {
        m.faceIndices.push_back(static_cast<uint32_t>(m.faceIndices.size()));
    }
    m.nodes.push_back(BVH::Node{m.mesh.getBounds(), 0, numFaces});
    m.todo.emplace_back(0, 0);
    return &fetch;
}

S fetch(Machine& m) {
    if (m.todo.empty()) {
        return &stop;
    }
    std::tie(m.index, m.depth) = m.todo.back();
    m.todo.pop_back();
    return &decide;
}

S decide(Machine& m) {
    const BVH::Node& node = m.nodes[m.index];
    const bool isSmall = node.facesEnd - node.facesBegin <= BVH::numFacesPerLeaf;
    const bool isDeep = m.depth >= BVH::maxDepth;
    return isSmall || isDeep ? &fetch : &partition;
}

S partition(Machine& m) {
    const BVH::Node& node = m.nodes[m.index];
    const auto axis = node.bounds.extents().maxDimension();
    m.middle = node.facesBegin + (node.facesEnd - node.facesBegin) / 2;
    const auto begin = m.faceIndices.begin();
    std::nth_element(begin + node.facesBegin, begin + m.middle, begin + node.facesEnd,
                     [&mesh = m.mesh, axis](uint32_t a, uint32_t b) {
                         const Triangle s = mesh.getTriangleFromFaceIndex(a);
                         const Triangle t = mesh.getTriangleFromFaceIndex(b);
                         return (s.v1[axis] + s.v2[axis] + s.v3[axis]) / 3.0f <
                                (t.v1[axis] + t.v2[axis] + t.v3[axis]) / 3.0f;
                     });
    return &attachChildren;
}

S attachChildren(Machine& m) {
    const size_t left = 2 * m.index + 1;
    if (m.nodes.size() < left + 2) {
        m.nodes.resize(left + 2);
    }
    const uint32_t cuts[] = {m.nodes[m.index].facesBegin, m.middle, m.nodes[m.index].facesEnd};
    for (size_t side = 0; side < 2; ++side) {
        BVH::Node child{AABB{}, cuts[side], cuts[side + 1]};
        for (uint32_t i = child.facesBegin; i < child.facesEnd; ++i) {
            const Triangle t = m.mesh.getTriangleFromFaceIndex(m.faceIndices[i]);
            child.bounds.extend(t.v1);
            child.bounds.extend(t.v2);
            child.bounds.extend(t.v3);
        }
        m.nodes[left + side] = child;
        m.todo.emplace_back(left + side, m.depth + 1);
    }
    return &fetch;
}

S stop(Machine&) {
    return {};
}

} // namespace build

void BVH::construct(const Mesh& mesh) {
    build::Machine machine{mesh, nodes, faceIndices};
    runUntilDone<build::Machine>(&build::start, machine);
}

// --- tracing ----------------------------------------------------------------------------------

namespace trace {

struct Machine {
    const Mesh& mesh;
    const std::vector<BVH::Node>& nodes;
    IntersectionRay ray;
    Intersection closest{};
    std::array<uint32_t, 64> stack{};
    size_t stackSize{0};
    size_t index{0};
};
using S = State<Machine>;

S test(Machine&);
S descend(Machine&);
S testFaces(Machine&);
S pop(Machine&);

S test(Machine& m) {
    return intersect(m.nodes[m.index].bounds, m.ray) ? &descend : &pop;
}

S descend(Machine& m) {
    const size_t left = 2 * m.index + 1;
    const size_t right = 2 * m.index + 2;
    if (right >= m.nodes.size() || m.nodes[left].facesEnd == 0 || m.nodes[right].facesEnd == 0) {
        return &testFaces;
    }
    m.stack[m.stackSize++] = static_cast<uint32_t>(left);
    m.index = right;
    return &test;
}

S testFaces(Machine& m) {
    for (const uint32_t face : m.mesh.getBVH().getFaceIndices(m.nodes[m.index])) {
        const Intersection hit = intersect(m.mesh.getTriangleFromFaceIndex(face), m.ray);
        if (hit.t < m.closest.t) {
            m.closest = hit;
            m.ray.t_max = hit.t;
        }
    }
    return &pop;
}

S pop(Machine& m) {
    if (m.stackSize == 0) {
        return {};
    }
    m.index = m.stack[--m.stackSize];
    return &test;
}

} // namespace trace

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    trace::Machine machine{mesh, mesh.getBVH().getNodes(), ray};
    if (!machine.nodes.empty()) {
        runUntilDone<trace::Machine>(&trace::test, machine);
    }
    return machine.closest;
}
