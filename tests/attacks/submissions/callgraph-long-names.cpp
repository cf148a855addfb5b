// attack: a thousand names of four thousand letters, each called from 160 functions, which are spelled again for every call.
// grade: source.construct-loops, bvh.rebuild-starts-afresh, work.uses-the-tree
// expect: a <= full; b = full
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#define TEN(x) x x x x x x x x x x
#define E1(f, p) f(p##0) f(p##1) f(p##2) f(p##3) f(p##4) f(p##5) f(p##6) f(p##7) f(p##8) f(p##9)
#define E2(f, p) E1(f, p##0) E1(f, p##1) E1(f, p##2) E1(f, p##3) E1(f, p##4) E1(f, p##5) E1(f, p##6) E1(f, p##7) E1(f, p##8) E1(f, p##9)
#define E3(f, p) E2(f, p##0) E2(f, p##1) E2(f, p##2) E2(f, p##3) E2(f, p##4) E2(f, p##5) E2(f, p##6) E2(f, p##7) E2(f, p##8) E2(f, p##9)
#define BEGIN(p) ".type " #p ", @function\n" #p ":\n"
#define END(p) ".size " #p ", 1\n"
#define PART "bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb"
#define ROW(p) "call _Z1f" PART PART PART PART PART PART #p "\n"
// Ten owners and the same thousand calls in each group: 160,000 different pairs, 63 MB.
#define GROUP(p) E1(BEGIN, p) E3(ROW, k) E1(END, p)
asm("/*\n" GROUP(a0) GROUP(a1) GROUP(a2) GROUP(a3) GROUP(a4) GROUP(a5) GROUP(a6) GROUP(a7) GROUP(a8) GROUP(a9) GROUP(c0) GROUP(c1) GROUP(c2) GROUP(c3) GROUP(c4) GROUP(c5) "*/");

void BVH::construct(const Mesh& mesh) {
    const auto count = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(count);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.assign(1, Node{mesh.getBounds(), 0, count});
    for (size_t i = 0; i < nodes.size() && i + 1 < size_t{1} << maxDepth; ++i) {
        const auto [bounds, begin, end] = nodes[i];
        if (end - begin <= numFacesPerLeaf)
            continue;
        const uint8_t axis = bounds.extents().maxDimension();
        const auto key = [&mesh, axis](uint32_t f) {
            const Triangle t = mesh.getTriangleFromFaceIndex(f);
            return (t.v1[axis] + t.v2[axis] + t.v3[axis]) / 3;
        };
        const auto all = faceIndices.begin();
        const uint32_t middle = begin + (end - begin) / 2;
        std::nth_element(all + begin, all + middle, all + end,
                         [&key](uint32_t a, uint32_t b) { return key(a) < key(b); });
        nodes.resize(std::max(nodes.size(), 2 * i + 3));
        nodes[2 * i + 1] = {{}, begin, middle};
        nodes[2 * i + 2] = {{}, middle, end};
        for (Node* child : {&nodes[2 * i + 1], &nodes[2 * i + 2]})
            for (const uint32_t f : getFaceIndices(*child))
                for (const Triangle t = mesh.getTriangleFromFaceIndex(f);
                     const Point3D& corner : {t.v1, t.v2, t.v3})
                    child->bounds.extend(corner);
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const auto& nodes = mesh.getBVH().getNodes();
    Intersection best;
    std::vector<size_t> todo{0};
    while (!todo.empty()) {
        const size_t i = todo.back();
        todo.pop_back();
        if (i >= nodes.size() || nodes[i].facesEnd == 0 || !intersect(nodes[i].bounds, ray))
            continue;
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 2].facesEnd != 0) {
            todo.insert(todo.end(), {2 * i + 2, 2 * i + 1});
            continue;
        }
        for (const uint32_t f : mesh.getBVH().getFaceIndices(nodes[i]))
            if (const auto hit = intersect(mesh.getTriangleFromFaceIndex(f), ray); hit.t < best.t)
                best = hit;
    }
    return best;
}
