// attack: calls itself by an instruction that is spelled in bytes, as data amid the code.
// grade: source.construct-loops, bvh.splits-at-the-median
// expect: fails source.construct-loops; passes bvh.splits-at-the-median; no stop
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

static AABB boxOf(const Mesh& mesh, const uint32_t* first, const uint32_t* past) {
    AABB box;
    for (; first != past; ++first) {
        const Triangle t = mesh.getTriangleFromFaceIndex(*first);
        box.extend(t.v1);
        box.extend(t.v2);
        box.extend(t.v3);
    }
    return box;
}

static void halve(const Mesh& mesh, uint32_t* begin, uint32_t* middle, uint32_t* end, int axis) {
    std::nth_element(begin, middle, end, [&](uint32_t a, uint32_t b) {
        const Triangle s = mesh.getTriangleFromFaceIndex(a), t = mesh.getTriangleFromFaceIndex(b);
        return s.v1[axis] + s.v2[axis] + s.v3[axis] < t.v1[axis] + t.v2[axis] + t.v3[axis];
    });
}

struct Work {
    const Mesh* mesh;
    std::vector<BVH::Node>* nodes;
    uint32_t* f;
};

extern "C" __attribute__((visibility("hidden"), used, noinline)) void deeper(Work* work, size_t i);

#if defined(__x86_64__)
static inline void again(Work* work, size_t i) {
    asm volatile("mov %%rsp, %%rbx\n\t"
                 "sub $256, %%rsp\n\t"
                 "and $-64, %%rsp\n\t"
                 ".byte 0xe8\n\t"
                 ".long deeper - . - 4\n\t"
                 "mov %%rbx, %%rsp\n\t"
                 : "+D"(work), "+S"(i)
                 :
                 : "rax", "rbx", "rcx", "rdx", "r8", "r9", "r10", "r11", "memory", "cc", "xmm0",
                   "xmm1", "xmm2", "xmm3", "xmm4", "xmm5", "xmm6", "xmm7", "xmm8", "xmm9", "xmm10",
                   "xmm11", "xmm12", "xmm13", "xmm14", "xmm15");
}
#else
static inline void again(Work* work, size_t i) { deeper(work, i); }
#endif

void deeper(Work* work, size_t i) {
    const Mesh& mesh = *work->mesh;
    std::vector<BVH::Node>& nodes = *work->nodes;
    uint32_t* const f = work->f;
    const BVH::Node node = nodes[i];
    if (node.facesEnd - node.facesBegin <= BVH::numFacesPerLeaf || (i + 1) >> BVH::maxDepth) {
        return;
    }
    if (nodes.size() < 2 * i + 3) {
        nodes.resize(2 * i + 3);
    }
    const uint32_t middle = node.facesBegin + (node.facesEnd - node.facesBegin) / 2;
    halve(mesh, f + node.facesBegin, f + middle, f + node.facesEnd,
          node.bounds.extents().maxDimension());
    nodes[2 * i + 1] =
        BVH::Node{boxOf(mesh, f + node.facesBegin, f + middle), node.facesBegin, middle};
    nodes[2 * i + 2] = BVH::Node{boxOf(mesh, f + middle, f + node.facesEnd), middle, node.facesEnd};
    again(work, 2 * i + 1);
    again(work, 2 * i + 2);
}

void BVH::construct(const Mesh& mesh) {
    *this = {};
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);
    nodes.push_back(Node{mesh.getBounds(), 0, numFaces});
    Work work{&mesh, &nodes, faceIndices.data()};
    again(&work, 0);
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    Intersection closest;
    std::vector<size_t> todo;
    if (!nodes.empty()) {
        todo.push_back(0);
    }
    while (!todo.empty()) {
        const size_t i = todo.back();
        todo.pop_back();
        if (!intersect(nodes[i].bounds, ray)) {
            continue;
        }
        const size_t left = 2 * i + 1;
        if (left + 1 < nodes.size() && nodes[left].facesEnd != 0) {
            todo.push_back(left);
            todo.push_back(left + 1);
            continue;
        }
        for (const uint32_t face : bvh.getFaceIndices(nodes[i])) {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
            if (hit.t < closest.t) {
                closest = hit;
            }
        }
    }
    return closest;
}
