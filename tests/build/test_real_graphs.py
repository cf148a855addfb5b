"""Call graphs of real compilers tell loops from recursion."""

from pathlib import Path

import pytest

from grader.model.cases import SourceCase
from grader.model.verdict import Verdict
from grader.verify.source import construct_loops
from tests.build.compilers import COMPILERS, Compile
from tests.compiled import BEGIN, CONSTRUCT, INTERSECT, graph_of
from tests.verify.builder import findings

HEAD = BEGIN + "#include <functional>\n#include <thread>\n" + INTERSECT
GROW = "nodes.push_back(Node{mesh.getBounds(), 0, 0});"
OPEN = f"void BVH::construct(const Mesh& mesh) {{ {GROW} faceIndices.resize(9); "

RECURSIVE = {
    "construct itself": OPEN + "if (nodes.size() < 9) construct(mesh); }",
    "a function": """static void grow(std::vector<BVH::Node>& nodes, int depth) {
        nodes.push_back({}); if (depth) grow(nodes, depth - 1); }
        """ + OPEN + "grow(nodes, 3); }",
    "two functions in turns": """struct State { std::vector<BVH::Node>& nodes; };
        static void right(State& s, int d);
        static void left(State& s, int d) { s.nodes.push_back({}); if (d) right(s, d - 1); }
        static void right(State& s, int d) { if (d) left(s, d - 1); }
        """ + OPEN + "State s{nodes}; left(s, 3); }",
    "std::function": OPEN + """std::function<void(uint32_t)> split = [&](uint32_t i) {
        nodes.push_back({}); if (i) split(i - 1); }; split(3); }""",
    "a generic lambda": OPEN + """auto split = [&](auto& self, uint32_t i) -> void {
        nodes.push_back({}); if (i) self(self, i - 1); }; split(split, 3); }""",
    "a function of a constant node that writes by index": """
        static void grow(const BVH::Node& n, std::vector<BVH::Node>& all, uint32_t i) {
            all[i].facesEnd = n.facesEnd / 2; if (i) grow(all[i], all, i - 1); }
        """ + OPEN + "grow(nodes[0], nodes, 3); }",
    "a function of a constant node that writes through a pointer": """
        struct State { std::vector<BVH::Node>& nodes; };
        static void grow(const BVH::Node& n, State& s, uint32_t i) {
            s.nodes.data()[i].facesEnd = n.facesEnd / 2; if (i) grow(n, s, i - 1); }
        """ + OPEN + "State s{nodes}; grow(nodes[0], s, 3); }",
    "a function of a constant node that writes through a span": """
        struct State { std::span<BVH::Node> nodes; };
        static void grow(const BVH::Node& n, const State& s, uint32_t i) {
            s.nodes[i].facesEnd = n.facesEnd / 2; if (i) grow(n, s, i - 1); }
        """ + OPEN + "State s{nodes}; grow(nodes[0], s, 3); }",
    "a function of a constant node that writes through a kept iterator": """
        struct State { std::vector<BVH::Node>::iterator next; };
        static void grow(const BVH::Node& n, const State& s, uint32_t i) {
            s.next->facesEnd = n.facesEnd / 2; if (i) grow(*s.next, {s.next + 1}, i - 1); }
        """ + OPEN + "grow(nodes[0], {nodes.begin()}, 3); }",
    "a function of a constant node that makes boxes grow": """static BVH::Node* all;
        static void grow(const BVH::Node& n, const Mesh& mesh, uint32_t i) {
            all[i].bounds.extend(n.bounds.min); if (i) grow(all[i], mesh, i - 1); }
        """ + OPEN + "all = nodes.data(); grow(nodes[0], mesh, 3); }",
    "a function of a copy of a node that writes to another one": """
        static void grow(BVH::Node n, std::pair<int, BVH::Node>& all, uint32_t i) {
            all.second = n; if (i) grow(n, all, i - 1); }
        """ + OPEN + "std::pair<int, Node> all; grow(nodes[0], all, 3); }",
    "a function that writes to a node after it has read it": """
        struct State { std::vector<BVH::Node>& nodes; };
        static void grow(State& s, uint32_t i) {
            if (s.nodes[i].facesEnd < 3) s.nodes[i].facesEnd++; if (i) grow(s, i - 1); }
        """ + OPEN + "State s{nodes}; grow(s, 3); }",
    "a function that writes through a reference to a node": """
        struct State { std::vector<BVH::Node>& nodes; };
        static void grow(State& s, uint32_t i) {
            float& x = s.nodes.back().bounds.max.x; x = 3; if (i) grow(s, i - 1); }
        """ + OPEN + "State s{nodes}; grow(s, 3); }",
    "a virtual function that prints what it catches": """
        struct Step { virtual void run(std::vector<BVH::Node>& n, int d) {
            try { n.push_back({}); } catch (const std::exception& e) { std::cerr << e.what(); }
            if (Step* next = this; d) next->run(n, d - 1); } };
        """ + OPEN + "Step s; s.run(nodes, 3); }",
    "a function in a table of C's": """struct State; struct Ops { void (*step)(State*, int); };
        struct State { const Ops* ops; std::vector<BVH::Node>* nodes; };
        static void grow(State* s, int d) {
            s->nodes->push_back({}); if (d) s->ops->step(s, d - 1); }
        """ + OPEN + "Ops o{grow}; State s{&o, &nodes}; s.ops->step(&s, 3); }",
    "a function named ä": """static void ä(std::vector<BVH::Node>& n, int d) {
        n.push_back({}); if (d) ä(n, d - 1); }
        """ + OPEN + "ä(nodes, 3); }",
}  # fmt: skip

SORT = """static void quicksort(uint32_t* a, uint32_t* b, const Mesh& mesh, int axis) {
    if (b - a < 2) return;
    uint32_t* m = std::partition(a, b, [&](uint32_t f) {
        return mesh.getTriangleFromFaceIndex(f).v1[axis] < 0; });
    quicksort(a, m, mesh, axis); quicksort(m, b, mesh, axis); }
"""

LOOPS = {
    "overloads": """static AABB boxOf(const Triangle& t) { AABB b; b.extend(t.v1); return b; }
        static AABB boxOf(const Mesh& m, uint32_t f) {
            return boxOf(m.getTriangleFromFaceIndex(f)); }
        """ + OPEN + "nodes[0].bounds = boxOf(mesh, 0); }",
    "a recursive quicksort": SORT + OPEN + """
        quicksort(faceIndices.data(), faceIndices.data() + 9, mesh, 0); }""",
    "a recursive template for a comparator beside nodes": """
        template <class Less> void quicksort(uint32_t* a, uint32_t* b, Less less) {
            if (b - a < 2) return;
            uint32_t* m = std::partition(a, b, [&](uint32_t f) { return less(f, *a); });
            quicksort(a, m, less); quicksort(m + (m == a), b, less); }
        static void split(BVH::Node& node, const Mesh& mesh, uint32_t* a) {
            node.facesEnd = 3;
            quicksort(a, a + 9, [&](uint32_t f, uint32_t g) {
                return mesh.getTriangleFromFaceIndex(f).v1.x
                     < mesh.getTriangleFromFaceIndex(g).v1.x; }); }
        """ + OPEN + "split(nodes[0], mesh, faceIndices.data()); }",
    "function objects that use each other": OPEN + """
        std::function<float(uint32_t)> x = [&](uint32_t f) {
            return mesh.getTriangleFromFaceIndex(f).v1.x; };
        std::function<AABB(uint32_t)> box = [&](uint32_t f) {
            AABB b; b.min.x = x(f); b.extend(mesh.getTriangleFromFaceIndex(f).v1); return b; };
        nodes[0].bounds = box(0); }""",
    "function objects of one signature": OPEN + """
        std::function<void(uint32_t)> one = [&](uint32_t i) { nodes[i].facesEnd = 3; };
        std::function<void(uint32_t)> two = [&](uint32_t i) { nodes.push_back({}); one(i); };
        two(0); }""",
    "a member function of a thread that prints what it catches": """
        struct Builder { std::vector<BVH::Node>& nodes;
            void work() { try { nodes.push_back({}); }
                catch (const std::exception& e) { std::cerr << nodes.size() << e.what(); } }
            void run() { std::thread(&Builder::work, this).join(); } };
        """ + OPEN + "Builder b{nodes}; b.run(); }",
    "virtual functions that delete themselves": """
        struct Step { virtual ~Step() = default; virtual void run() = 0; };
        struct Split : Step { std::vector<BVH::Node>& nodes;
            explicit Split(std::vector<BVH::Node>& n) : nodes(n) {}
            void run() override { nodes.push_back({}); delete static_cast<Step*>(this); } };
        """ + OPEN + "Step* s = new Split(nodes); s->run(); }",
    "a recursive quickselect that looks into nodes": """
        struct State { std::vector<BVH::Node>& nodes; size_t i; };
        static void select(State& s, uint32_t* a, uint32_t* b) {
            const BVH::Node node = s.nodes[s.i];
            const float x = s.nodes[s.i].bounds.extents().x;
            if (b - a < 2 || s.nodes.at(s.i).facesEnd < s.nodes.back().facesEnd) return;
            uint32_t* m = std::partition(a, b, [&](uint32_t f) { return f < x; });
            select(s, a, m); select(s, m + (m == a), b); }
        """ + OPEN + "State s{nodes, 0}; select(s, &faceIndices[0], &faceIndices[0] + 9); }",
    "a recursive quickselect of records for a copy of a node": """struct Item { float x; };
        static void select(std::vector<Item>& all, BVH::Node n, size_t a, size_t b) {
            if (b - a < 2) return;
            std::swap(all[a], all[n.facesEnd % b]);
            select(all, n, a, b / 2); select(all, n, a + 1, b); }
        """ + OPEN + "std::vector<Item> all(9); select(all, nodes[0], 0, 9); }",
    "functions named ä and ö": """static void ä(BVH::Node& n) { n.facesEnd = 3; }
        static void ö(BVH::Node& n) { ä(n); }
        """ + OPEN + "ö(nodes[0]); }",
    "a comparator by pointer": """static bool less(uint32_t a, uint32_t b) { return a < b; }
        """ + OPEN + "std::sort(faceIndices.begin(), faceIndices.end(), less); }",
    "a recursive quickselect for a node": """
        static void select(const BVH::Node& n, uint32_t* a, uint32_t* b) {
            if (b - a < 2) return;
            const size_t axis = n.bounds.extents().maxDimension();
            uint32_t* m = std::partition(a, b, [&](uint32_t f) { return f < axis; });
            select(n, a, m); select(n, m + (m == a), b); }
        """ + OPEN + "select(nodes[0], &faceIndices[0], &faceIndices[0] + 9); }",
    "a recursive count of nodes that are there": """
        static size_t leaves(const std::vector<BVH::Node>& nodes, size_t i) {
            if (nodes.empty() || i >= nodes.size() || nodes.at(i).facesEnd == 0) return 0;
            const size_t below = leaves(nodes, 2 * i + 1) + leaves(nodes, 2 * i + 2);
            return below ? below : nodes[i].facesEnd > 0; }
        """ + OPEN + "faceIndices.resize(leaves(nodes, 0)); }",
    "a merge sort of a list with nodes of its own": """struct List {
            struct Node { uint32_t face; Node* next; };
            static Node* sort(Node* n, size_t count) {
                return count < 2 ? n : sort(sort(n, count / 2), count - count / 2); } };
        """ + OPEN + "List::Node n{}; faceIndices[0] = List::sort(&n, 9)->face; }",
    "intrinsics with immediate operands": """#include <immintrin.h>
        #ifdef __x86_64__
        static uint32_t first(const float* a, const uint32_t* b) {
            _mm_prefetch(reinterpret_cast<const char*>(b), _MM_HINT_T0);
            const __m128 x = _mm_set1_ps(*a);
            return uint32_t(_mm_cvtss_f32(_mm_shuffle_ps(x, x, _MM_SHUFFLE(3, 0, 2, 1)))); }
        #else
        static uint32_t first(const float* a, const uint32_t*) { return uint32_t(*a); }
        #endif
        """ + OPEN + "nodes[0].facesEnd = first(&nodes[0].bounds.min.x, &faceIndices[0]); }",
    "a queue, a stack and output": OPEN + """std::queue<Node> q; q.push(nodes[0]);
        std::stack<uint32_t> s; s.push(1); std::cout << s.top() << q.size() << std::endl; }""",
}  # fmt: skip


@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.usefixtures("cache")
def test_real_call_graphs_tell_loops_from_recursion(
    compiler: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Recursion is found with its line however it is written, and no loop is taken for one."""
    monkeypatch.setenv("CXX", compiler)
    for expected, sources in ((Verdict.FAIL, RECURSIVE), (Verdict.PASS, LOOPS)):
        for name, source in sources.items():
            folder = tmp_path / str(len(list(tmp_path.iterdir())))
            folder.mkdir()
            case = SourceCase("source", graph_of(HEAD + source + "\n", folder))
            found = findings(case)["source.construct-loops"]
            assert found.verdict is expected, (name, found)
            assert (found.evidence.line >= 6) == (expected is Verdict.FAIL), (name, found)


def test_recursion_of_intersect_is_allowed(compiled: Compile) -> None:
    """The sheet forbids recursion only in construct."""
    walk = """static void visit(const BVH& bvh, size_t i) {
    if (i < bvh.getNodes().size()) visit(bvh, 2 * i + 1); }
Intersection intersect(const Mesh& mesh, const IntersectionRay&) {
    visit(mesh.getBVH(), 0); return {}; }
"""
    build = compiled(BEGIN + walk + CONSTRUCT)
    assert build.calls
    assert construct_loops.decide(SourceCase("source", build.calls)).wrong == 0
