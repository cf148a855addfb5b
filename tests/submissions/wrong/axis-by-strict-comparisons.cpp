// expect: bvh.splits-the-longest-axis
// untouched: b
// mistake: An axis is chosen only if it is strictly longer than both others, otherwise x.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "triangle.h"

#include <numeric>

static Point3D triangleCenter(const Triangle& t) { return (t.v1 + t.v2 + t.v3) / 3.f; }

void BVH::construct(const Mesh& mesh)
{
    const uint32_t n = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(n);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.clear();
    nodes.push_back(Node{mesh.getBounds(), 0, n});

    std::vector<AABB> faceBoxes(n);
    std::vector<Point3D> centers(n);
    for (uint32_t f = 0; f < n; ++f) {
        const Triangle t = mesh.getTriangleFromFaceIndex(f);
        faceBoxes[f] = AABB{min(t.v1, min(t.v2, t.v3)), max(t.v1, max(t.v2, t.v3))};
        centers[f] = triangleCenter(t);
    }

    // the split needs only the extents of a node, so they are taken on the way down ...
    uint32_t level = 0;
    for (size_t begin = 0; begin < nodes.size() && level < maxDepth; begin = 2 * begin + 1, ++level) {
        const size_t end = std::min(nodes.size(), 2 * begin + 1);
        for (size_t i = begin; i < end; ++i) {
            const uint32_t first = nodes[i].facesBegin, last = nodes[i].facesEnd;
            if (last - first <= numFacesPerLeaf)
                continue;
            AABB box;
            for (uint32_t k = first; k < last; ++k)
                box.extend(faceBoxes[faceIndices[k]]);
            const Vector3D e = i == 0 ? mesh.getBounds().extents() : box.extents();
            int axis = 0;
            if (e.y > e.x && e.y > e.z)
                axis = 1;
            else if (e.z > e.x && e.z > e.y)
                axis = 2;
            const uint32_t mid = first + (last - first) / 2;
            std::nth_element(&faceIndices[first], &faceIndices[mid], faceIndices.data() + last, [&](uint32_t a, uint32_t b) {
                const float ca = centers[a][axis], cb = centers[b][axis];
                return ca < cb || (ca == cb && a < b);
            });
            if (nodes.size() < 2 * i + 3)
                nodes.resize(2 * i + 3);
            nodes[2 * i + 1] = Node{AABB{}, first, mid};
            nodes[2 * i + 2] = Node{AABB{}, mid, last};
        }
    }

    // ... and the boxes are put together on the way up
    for (size_t i = nodes.size(); i-- > 1;) {
        if (nodes[i].facesEnd == 0)
            continue;
        if (2 * i + 2 >= nodes.size() || nodes[2 * i + 1].facesEnd == 0)
            for (uint32_t face : getFaceIndices(nodes[i]))
                nodes[i].bounds.extend(faceBoxes[face]);
        nodes[(i - 1) / 2].bounds.extend(nodes[i].bounds);
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    // keeps only nodes on the stack whose box the ray meets
    std::vector<size_t> stack;
    if (!nodes.empty() && intersect(nodes[0].bounds, ray))
        stack.push_back(0);
    while (!stack.empty()) {
        const size_t node = stack.back();
        stack.pop_back();
        if (2 * node + 2 < nodes.size() && nodes[2 * node + 2].facesEnd > 0) {
            for (size_t child : {2 * node + 2, 2 * node + 1})
                if (intersect(nodes[child].bounds, ray))
                    stack.push_back(child);
            continue;
        }
        for (uint32_t face : bvh.getFaceIndices(nodes[node])) {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
            if (hit.t < best.t)
                best = hit;
        }
    }
    return best;
}
