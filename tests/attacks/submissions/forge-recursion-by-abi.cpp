// attack: lets the grader's door call construct again, without end.
// grade: bvh.rebuild-starts-afresh, work.uses-the-tree
// expect: a = 0; b = full; stop crashed
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

extern "C" int32_t ex03_construct(void*, const void*);

void BVH::construct(const Mesh& mesh) {
    volatile char deep[4096] = {};
    ex03_construct(this, &mesh);
    deep[1] = 0;
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
