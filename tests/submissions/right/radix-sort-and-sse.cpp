// right: least-significant-digit radix sort on the bits of the centres; the box test in SSE intrinsics with prefetching of the children
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"

#include <bit>
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace {

struct Item {
    uint32_t key;
    uint32_t face;
};

/// Maps floats to integers of the same order.
constexpr uint32_t sortableBits(float value)
{
    const uint32_t bits = std::bit_cast<uint32_t>(value);
    return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}
static_assert(sortableBits(-1.f) < sortableBits(-0.5f) && sortableBits(-0.5f) < sortableBits(0.f) && sortableBits(0.f) < sortableBits(2.f));

void radixSort(std::vector<Item>& items, std::vector<Item>& scratch)
{
    scratch.resize(items.size());
    for (int shift = 0; shift < 32; shift += 8) {
        std::array<uint32_t, 257> offsets{};
        for (const Item& item : items)
            ++offsets[((item.key >> shift) & 0xffu) + 1];
        std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
        for (const Item& item : items)
            scratch[offsets[(item.key >> shift) & 0xffu]++] = item;
        items.swap(scratch);
    }
}

void sortByKey(std::vector<Item>& items, std::vector<Item>& scratch)
{
    if (items.size() > 256)
        radixSort(items, scratch);
    else
        std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return a.key < b.key; });
}

#if defined(__SSE2__)
/// All three slabs at once. minps and maxps return their second operand if one is not a number.
struct alignas(16) FastRay {
    __m128 origin, inverse, near, far;

    explicit FastRay(const IntersectionRay& ray)
        : origin(_mm_setr_ps(ray.origin.x, ray.origin.y, ray.origin.z, 0.f)),
          inverse(_mm_setr_ps(ray.inv_direction.x, ray.inv_direction.y, ray.inv_direction.z, 0.f)),
          near(_mm_set1_ps(ray.t_min)), far(_mm_set1_ps(ray.t_max)) {}

    bool hits(const AABB& box) const
    {
        const __m128 low = _mm_setr_ps(box.min.x, box.min.y, box.min.z, 0.f);
        const __m128 high = _mm_setr_ps(box.max.x, box.max.y, box.max.z, 0.f);
        const __m128 a = _mm_mul_ps(_mm_sub_ps(low, origin), inverse);
        const __m128 b = _mm_mul_ps(_mm_sub_ps(high, origin), inverse);
        // a slab in whose plane the ray runs says nothing
        const __m128 valid = _mm_and_ps(_mm_cmpord_ps(a, b), _mm_castsi128_ps(_mm_setr_epi32(-1, -1, -1, 0)));
        const __m128 enter = _mm_or_ps(_mm_and_ps(valid, _mm_min_ps(a, b)), _mm_andnot_ps(valid, near));
        const __m128 leave = _mm_or_ps(_mm_and_ps(valid, _mm_max_ps(a, b)), _mm_andnot_ps(valid, far));
        alignas(16) float e[4], l[4];
        _mm_store_ps(e, _mm_max_ps(near, enter));
        _mm_store_ps(l, _mm_min_ps(far, _mm_add_ps(leave, _mm_mul_ps(_mm_andnot_ps(_mm_set1_ps(-0.f), leave), _mm_set1_ps(2e-6f)))));
        const float nearest = std::max(std::max(e[0], e[1]), e[2]);
        const float farthest = std::min(std::min(l[0], l[1]), l[2]);
        return nearest <= farthest;
    }
};
#else
struct FastRay {
    const IntersectionRay& ray;
    explicit FastRay(const IntersectionRay& ray) : ray(ray) {}
    bool hits(const AABB& box) const { return intersect(box, ray); }
};
#endif

} // namespace

void BVH::construct(const Mesh& mesh)
{
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    std::vector<AABB> boxes(numFaces);
    std::vector<Point3D> centers(numFaces);
    faceIndices.resize(numFaces);
    for (uint32_t f = 0; f < numFaces; ++f) {
        const Triangle t = mesh.getTriangleFromFaceIndex(f);
        boxes[f] = {min(min(t.v1, t.v2), t.v3), max(max(t.v1, t.v2), t.v3)};
        centers[f] = (t.v1 + t.v2 + t.v3) / 3.f;
        faceIndices[f] = f;
    }
    nodes.assign(1, {mesh.getBounds(), 0, numFaces});

    std::vector<Item> items, scratch;
    for (size_t i = 0; i < nodes.size() && i + 1 < size_t{1} << maxDepth; ++i) {
        const uint32_t begin = nodes[i].facesBegin, end = nodes[i].facesEnd;
        if (end <= begin + numFacesPerLeaf)
            continue;
        const auto axis = nodes[i].bounds.extents().maxDimension();
        items.clear();
        for (uint32_t k = begin; k < end; ++k)
            items.push_back({sortableBits(centers[faceIndices[k]][axis]), faceIndices[k]});
        sortByKey(items, scratch);

        const uint32_t middle = begin + (end - begin) / 2;
        AABB halves[2];
        for (uint32_t k = begin; k < end; ++k) {
            faceIndices[k] = items[k - begin].face;
            halves[k >= middle].extend(boxes[faceIndices[k]]);
        }
        if (nodes.size() < 2 * i + 3)
            nodes.resize(2 * i + 3);
        nodes[2 * i + 1] = {halves[0], begin, middle};
        nodes[2 * i + 2] = {halves[1], middle, end};
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    const BVH& bvh = mesh.getBVH();
    const BVH::Node* const nodes = bvh.getNodes().data();
    const size_t numNodes = bvh.getNodes().size();
    const FastRay fast(ray);
    Intersection best;
    alignas(64) uint32_t stack[64];
    uint32_t size = 0;
    if (numNodes > 0) [[likely]]
        stack[size++] = 0;
    while (size > 0) {
        const uint32_t i = stack[--size];
        if (!fast.hits(nodes[i].bounds))
            continue;
        const size_t left = 2 * size_t{i} + 1;
        if (left < numNodes && nodes[left].facesEnd != 0) [[likely]] {
            __builtin_prefetch(&nodes[left]);
            stack[size++] = static_cast<uint32_t>(left + 1);
            stack[size++] = static_cast<uint32_t>(left);
            continue;
        }
        for (const uint32_t face : bvh.getFaceIndices(nodes[i])) {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
            if (hit.t < best.t)
                best = hit;
        }
    }
    return best;
}
