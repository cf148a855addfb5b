// right: whatever makes it fast: OpenMP and GCC pragmas, inline assembly, attributes, restrict pointers, a static scratch buffer in construct
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#pragma once
#pragma GCC optimize("O3,unroll-loops")
#pragma STDC FP_CONTRACT OFF
#include <cassert>
#include <climits>
#include <thread>
#ifdef _OPENMP
#include <omp.h>
#endif

#define HOT __attribute__((hot, noinline))
#define INLINE __attribute__((always_inline)) static inline
#define likely(x) __builtin_expect(!!(x), 1)
#define unlikely(x) __builtin_expect(!!(x), 0)

static_assert(CHAR_BIT == 8 && sizeof(BVH::Node) == 32, "two nodes are a cache line");

struct alignas(16) Center {
    float c[4];
};

// Reused from call to call; construct is called by one thread only.
static std::vector<Center> centers;

INLINE void nop()
{
#if defined(__x86_64__)
    asm volatile("nop" ::: "memory");
#endif
}

HOT static AABB boundsOf(const uint32_t* __restrict first, const uint32_t* __restrict last, const Mesh& mesh)
{
    const Point3D* __restrict v = mesh.getVertices().data();
    const TriangleIndices* __restrict f = mesh.getFaces().data();
    float low[3] = {infinity, infinity, infinity}, high[3] = {-infinity, -infinity, -infinity};
    for (; first != last; ++first) {
        const uint32_t corner[3] = {f[*first].v1, f[*first].v2, f[*first].v3};
#pragma GCC unroll 3
        for (int k = 0; k < 3; ++k) {
            const float p[3] = {v[corner[k]].x, v[corner[k]].y, v[corner[k]].z};
#pragma omp simd
            for (int d = 0; d < 3; ++d) {
                low[d] = p[d] < low[d] ? p[d] : low[d];
                high[d] = p[d] > high[d] ? p[d] : high[d];
            }
        }
    }
    return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

void BVH::construct(const Mesh& mesh)
{
    const int64_t numFaces = static_cast<int64_t>(mesh.getFaces().size());
    centers.assign(numFaces, {});
    faceIndices.resize(numFaces);
#pragma omp parallel for schedule(static)
    for (int64_t f = 0; f < numFaces; ++f) {
        const Triangle t = mesh.getTriangleFromFaceIndex(f);
        for (int d = 0; d < 3; ++d)
            centers[f].c[d] = (t.v1[d] + t.v2[d] + t.v3[d]) * (1.f / 3.f);
        faceIndices[f] = static_cast<uint32_t>(f);
    }

    nodes.clear();
    nodes.push_back({mesh.getBounds(), 0, static_cast<uint32_t>(numFaces)});
    for (uint32_t level = 0; level < maxDepth; ++level) {
        const int64_t first = (int64_t(1) << level) - 1;
        const int64_t last = std::min<int64_t>(nodes.size(), 2 * first + 1);
        int64_t deepest = -1;
        for (int64_t i = first; i < last; ++i)
            if (nodes[i].facesEnd - nodes[i].facesBegin > numFacesPerLeaf)
                deepest = i;
        if (unlikely(deepest < 0))
            break;
        nodes.resize(2 * deepest + 3);
#pragma omp parallel for schedule(dynamic, 1)
        for (int64_t i = first; i <= deepest; ++i) {
            const uint32_t begin = nodes[i].facesBegin, end = nodes[i].facesEnd;
            if (end - begin <= numFacesPerLeaf)
                continue;
            const uint32_t middle = begin + (end - begin) / 2;
            const int axis = nodes[i].bounds.extents().maxDimension();
            assert(axis < 3 && begin < middle && middle < end);
            uint32_t* const p = faceIndices.data();
            std::nth_element(p + begin, p + middle, p + end,
                             [axis, c = centers.data()](uint32_t a, uint32_t b) { return c[a].c[axis] < c[b].c[axis]; });
            nodes[2 * i + 1] = {boundsOf(p + begin, p + middle, mesh), begin, middle};
            nodes[2 * i + 2] = {boundsOf(p + middle, p + end, mesh), middle, end};
            nop();
        }
    }
    std::this_thread::yield();
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    const uint64_t n = nodes.size();
    Intersection closest;
    if (unlikely(n == 0))
        return closest;
    alignas(64) uint64_t stack[BVH::maxDepth + 1];
    uint64_t* sp = stack;
    *sp++ = 0;
    do {
        const uint64_t i = *--sp;
        __builtin_prefetch(nodes.data() + std::min(2 * i + 1, n - 1), 0, 3);
        if (likely(!intersect(nodes[i].bounds, ray)))
            continue;
        if (2 * i + 2 < n && nodes[2 * i + 1].facesEnd) {
            const bool flip = std::signbit(ray.direction[nodes[i].bounds.extents().maxDimension()]);
            sp[0] = 2 * i + 2 - flip;
            sp[1] = 2 * i + 1 + flip;
            sp += 2;
            continue;
        }
        for (const uint32_t face : bvh.getFaceIndices(nodes[i])) {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
            if (unlikely(hit.t < closest.t))
                closest = hit;
        }
    } while (sp != stack);
    return closest;
}
