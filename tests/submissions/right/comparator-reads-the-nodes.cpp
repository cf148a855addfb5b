// right: a recursive quickselect as the sorting helper; its comparator, within construct, looks the axis up in nodes[i], which is not constant there
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

// Puts the k-th of n faces where it would be if all were sorted, with smaller ones before it.
template <typename Less> static void quickSelect(uint32_t* faces, ptrdiff_t n, ptrdiff_t k, const Less& less) {
    if (n < 2)
        return;
    const uint32_t pivot = faces[n / 2];
    ptrdiff_t i = 0, j = n - 1;
    while (i <= j) {
        while (less(faces[i], pivot))
            ++i;
        while (less(pivot, faces[j]))
            --j;
        if (i <= j)
            std::swap(faces[i++], faces[j--]);
    }
    if (k <= j)
        quickSelect(faces, j + 1, k, less);
    else if (k >= i)
        quickSelect(faces + i, n - i, k - i, less);
}

void BVH::construct(const Mesh& mesh) {
    const uint32_t numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);
    nodes.clear();
    nodes.push_back(Node{mesh.getBounds(), 0, numFaces});

    std::vector<Point3D> centers(numFaces);
    for (uint32_t f = 0; f < numFaces; ++f) {
        const Triangle t = mesh.getTriangleFromFaceIndex(f);
        centers[f] = (t.v1 + t.v2 + t.v3) / 3.0f;
    }

    // Level by level; level d begins with node 2^d - 1.
    for (uint32_t depth = 0; depth < maxDepth; ++depth) {
        const size_t first = (size_t{1} << depth) - 1;
        const size_t last = std::min(2 * first + 1, nodes.size());
        for (size_t i = first; i < last; ++i) {
            const uint32_t begin = nodes[i].facesBegin, end = nodes[i].facesEnd;
            if (end - begin <= numFacesPerLeaf)
                continue;
            const uint32_t mid = begin + (end - begin) / 2;
            quickSelect(faceIndices.data() + begin, end - begin, mid - begin, [&](uint32_t a, uint32_t b) {
                const uint8_t axis = nodes[i].bounds.extents().maxDimension();
                return centers[a][axis] < centers[b][axis];
            });
            if (nodes.size() < 2 * i + 3)
                nodes.resize(2 * i + 3);
            nodes[2 * i + 1] = Node{AABB{}, begin, mid};
            nodes[2 * i + 2] = Node{AABB{}, mid, end};
            for (size_t child = 2 * i + 1; child <= 2 * i + 2; ++child)
                for (uint32_t face : getFaceIndices(nodes[child])) {
                    const Triangle t = mesh.getTriangleFromFaceIndex(face);
                    nodes[child].bounds.extend(t.v1);
                    nodes[child].bounds.extend(t.v2);
                    nodes[child].bounds.extend(t.v3);
                }
        }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    Intersection best;
    std::vector<size_t> stack;
    if (!nodes.empty())
        stack.push_back(0);
    while (!stack.empty()) {
        const size_t i = stack.back();
        stack.pop_back();
        if (!intersect(nodes[i].bounds, ray))
            continue;
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd != 0) {
            stack.push_back(2 * i + 1);
            stack.push_back(2 * i + 2);
            continue;
        }
        for (uint32_t face : bvh.getFaceIndices(nodes[i])) {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
            if (hit.t < best.t)
                best = hit;
        }
    }
    return best;
}
