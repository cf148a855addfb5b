// right: SSE intrinsics with immediate operands: the longest axis by _mm_shuffle_ps, the children fetched ahead by _mm_prefetch
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include <immintrin.h>

static uint32_t longestAxis(const AABB& box) {
    const Vector3D e = box.extents();
    const __m128 xyz = _mm_setr_ps(e.x, e.y, e.z, e.z);
    const __m128 yzx = _mm_shuffle_ps(xyz, xyz, _MM_SHUFFLE(3, 0, 2, 1));
    const __m128 zxy = _mm_shuffle_ps(xyz, xyz, _MM_SHUFFLE(3, 1, 0, 2));
    const __m128 largest = _mm_max_ps(xyz, _mm_max_ps(yzx, zxy));
    const unsigned which = _mm_movemask_ps(_mm_cmpge_ps(xyz, largest)) & 7u;
    return which ? std::countr_zero(which) : 0;
}

void BVH::construct(const Mesh& mesh) {
    const uint32_t numFaces = uint32_t(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.assign(1, Node{mesh.getBounds(), 0, numFaces});
    std::vector<Point3D> centres(numFaces);
    std::vector<AABB> boxes(numFaces);
    for (uint32_t f = 0; f < numFaces; ++f) {
        const Triangle t = mesh.getTriangleFromFaceIndex(f);
        centres[f] = (t.v1 + t.v2 + t.v3) / 3.f;
        boxes[f] = {min(min(t.v1, t.v2), t.v3), max(max(t.v1, t.v2), t.v3)};
    }
    for (size_t i = 0; i < nodes.size() && i < (size_t(1) << maxDepth) - 1; ++i) {
        const Node node = nodes[i];
        const uint32_t count = node.facesEnd - node.facesBegin;
        if (count <= numFacesPerLeaf)
            continue;
        const uint32_t axis = longestAxis(node.bounds), mid = node.facesBegin + (count + 1) / 2;
        uint32_t* const f = faceIndices.data();
        std::nth_element(f + node.facesBegin, f + mid, f + node.facesEnd,
                         [&](uint32_t a, uint32_t b) { return centres[a][axis] < centres[b][axis]; });
        Node left{{}, node.facesBegin, mid}, right{{}, mid, node.facesEnd};
        for (uint32_t k = node.facesBegin; k < node.facesEnd; ++k)
            (k < mid ? left : right).bounds.extend(boxes[f[k]]);
        nodes.resize(std::max(nodes.size(), 2 * i + 3));
        nodes[2 * i + 1] = left;
        nodes[2 * i + 2] = right;
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const auto& nodes = mesh.getBVH().getNodes();
    Intersection best;
    IntersectionRay rest = ray;
    size_t stack[64];
    int top = 0;
    if (!nodes.empty())
        stack[top++] = 0;
    while (top > 0) {
        const size_t i = stack[--top], left = 2 * i + 1;
        const bool inner = left + 1 < nodes.size() && nodes[left].facesEnd != 0;
        if (inner)
            _mm_prefetch(reinterpret_cast<const char*>(&nodes[left]), _MM_HINT_T0);
        if (!intersect(nodes[i].bounds, rest))
            continue;
        if (inner) {
            stack[top++] = left + 1;
            stack[top++] = left;
            continue;
        }
        for (const uint32_t f : mesh.getBVH().getFaceIndices(nodes[i]))
            if (const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(f), rest)) {
                best = hit;
                rest.t_max = hit.t;
            }
    }
    return best;
}
