// right: unused slots are zeroed bytes; an own box test compiled for several processors (target_clones), in double with explicit zeros
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include <alloca.h>
#include <cstring>
#include <memory>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define FOR_EVERY_CPU __attribute__((target_clones("avx2", "sse4.2", "default"), noinline))
#else
#define FOR_EVERY_CPU
#endif

Point3D& operator+=(Point3D& a, const Point3D& b) { return a = a + b; }

struct Slab { double lo[3], hi[3]; };

FOR_EVERY_CPU static bool overlaps(const Slab* box, const double* origin, const double* direction, double from, double to)
{
    for (int k = 0; k < 3; k++) {
        if (direction[k] == 0) {
            if (origin[k] < box->lo[k] || origin[k] > box->hi[k])
                return false;
            continue;
        }
        const double a = (box->lo[k] - origin[k]) / direction[k], b = (box->hi[k] - origin[k]) / direction[k];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    // the hits are in float, so that they may lie a little outside of a flat box
    return from <= to + 1e-6 * (std::abs(to) + std::abs(from));
}

void BVH::construct(const Mesh& mesh)
{
    const uint32_t n = uint32_t(mesh.getFaces().size());
    faceIndices = std::vector<uint32_t>(n);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);
    if (n == 0) {
        nodes = {};
        return;
    }
    std::unique_ptr<Point3D[]> centers(new Point3D[n]);
    for (uint32_t f = 0; f < n; f++) {
        const Triangle t = mesh.getTriangleFromFaceIndex(f);
        centers[f] += t.v1;
        centers[f] += t.v2;
        centers[f] += t.v3;
    }
    const size_t most = std::min<size_t>(2 * size_t(roundUpPowerOfTwo(n)) - 1, (size_t(2) << maxDepth) - 1);
    Node zero;
    std::memset(static_cast<void*>(&zero), 0, sizeof zero);
    nodes.assign(most, zero);
    nodes[0].bounds = mesh.getBounds();
    nodes[0].facesEnd = n;

    uint32_t* const pending = static_cast<uint32_t*>(alloca((maxDepth + 2) * sizeof(uint32_t)));
    uint32_t count = 0;
    pending[count++] = 0;
    do {
        const uint32_t i = pending[--count];
        const auto [bounds, begin, end] = nodes[i];
        const uint32_t depth = 31 - uint32_t(__builtin_clz(i + 1));
        if (end - begin <= numFacesPerLeaf || depth >= maxDepth)
            continue;
        const Vector3D size = bounds.max - bounds.min;
        const uint8_t axis = size.maxDimension();
        const uint32_t middle = begin + (end - begin) / 2;
        std::nth_element(faceIndices.begin() + begin, faceIndices.begin() + middle, faceIndices.begin() + end,
                         [&centers, axis](uint32_t a, uint32_t b) { return centers[a][axis] < centers[b][axis]; });
        struct { uint32_t index, begin, end; } const halves[] = {{2 * i + 1, begin, middle}, {2 * i + 2, middle, end}};
        for (const auto& half : halves) {
            Point3D low = mesh.getTriangleFromFaceIndex(faceIndices[half.begin]).v1, high = low;
            for (uint32_t k = half.begin; k < half.end; ++k) {
                const Triangle t = mesh.getTriangleFromFaceIndex(faceIndices[k]);
                for (int a = 0; a < 3; a++) {
                    low[a] = std::fmin(low[a], std::fmin(t.v1[a], std::fmin(t.v2[a], t.v3[a])));
                    high[a] = std::fmax(high[a], std::fmax(t.v1[a], std::fmax(t.v2[a], t.v3[a])));
                }
            }
            nodes[half.index] = Node{AABB{low, high}, half.begin, half.end};
            pending[count++] = half.index;
        }
    } while (count != 0);
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    const BVH& bvh = mesh.getBVH();
    const BVH::Node* nodes = bvh.getNodes().data();
    const size_t n = bvh.getNodes().size();
    const double o[3] = {ray.origin.x, ray.origin.y, ray.origin.z}, d[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
    Intersection best;
    std::array<size_t, 64> stack;
    auto top = stack.begin();
    if (n > 0)
        *top++ = 0;
    while (top != stack.begin()) {
        const size_t i = *--top;
        const auto& [low, high] = nodes[i].bounds;
        const Slab slab{{low.x, low.y, low.z}, {high.x, high.y, high.z}};
        if (!overlaps(&slab, o, d, ray.t_min, std::min(ray.t_max, best.t)))
            continue;
        if (2 * i + 2 < n && nodes[2 * i + 1].facesEnd != 0) {
            *top++ = 2 * i + 1;
            *top++ = 2 * i + 2;
            continue;
        }
        for (uint32_t f : bvh.getFaceIndices(nodes[i]))
            if (const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(f), ray); hit.t < best.t)
                best = hit;
    }
    return best;
}
