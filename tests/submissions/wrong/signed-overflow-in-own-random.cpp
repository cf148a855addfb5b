// expect: bvh.memory-is-safe
// untouched: b
// mistake: The random pivot of the own quickselect comes from signed arithmetic that overflows.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <bit>
#include <utility>
#include <vector>

static void quickselect(uint32_t* faces, long count, long k, const std::vector<double>& key)
{
    int random = 12345;
    long low = 0, high = count - 1;
    while (low < high) {
        random = random * 1103515245 + 12345;
        const double pivot = key[faces[low + (random & 0xffff) % (high - low + 1)]];
        long i = low, j = high;
        while (i <= j) {
            while (key[faces[i]] < pivot) ++i;
            while (pivot < key[faces[j]]) --j;
            if (i <= j)
                std::swap(faces[i++], faces[j--]);
        }
        if (k <= j)
            high = j;
        else if (k >= i)
            low = i;
        else
            return;
    }
}

void BVH::construct(const Mesh& mesh)
{
    const uint32_t numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::vector<double> keys[3];
    for (int axis = 0; axis < 3; ++axis)
        keys[axis].resize(numFaces);
    for (uint32_t f = 0; f < numFaces; ++f) {
        faceIndices[f] = f;
        const Triangle t = mesh.getTriangleFromFaceIndex(f);
        for (int axis = 0; axis < 3; ++axis)
            keys[axis][f] = (double(t.v1[axis]) + double(t.v2[axis]) + double(t.v3[axis])) / 3.0;
    }
    nodes.clear();
    nodes.push_back(Node{mesh.getBounds(), 0, numFaces});

    uint32_t depth = 0, nextLevel = 1;
    for (uint32_t i = 0; i < nodes.size(); ++i) {
        if (i == nextLevel) {
            ++depth;
            nextLevel = 2 * nextLevel + 1;
        }
        if (depth >= maxDepth)
            break;
        const Node node = nodes[i];
        const uint32_t count = node.facesEnd - node.facesBegin;
        if (count <= numFacesPerLeaf)
            continue;
        quickselect(faceIndices.data() + node.facesBegin, count, count / 2, keys[node.bounds.extents().maxDimension()]);

        if (nodes.size() <= 2 * i + 2)
            nodes.resize(2 * i + 3);
        const uint32_t cut[3] = {node.facesBegin, node.facesBegin + count / 2, node.facesEnd};
        for (int c = 0; c < 2; ++c) {
            AABB box;
            for (uint32_t k = cut[c]; k < cut[c + 1]; ++k) {
                const Triangle t = mesh.getTriangleFromFaceIndex(faceIndices[k]);
                box.min = min(min(box.min, t.v1), min(t.v2, t.v3));
                box.max = max(max(box.max, t.v1), max(t.v2, t.v3));
            }
            nodes[2 * i + 1 + c] = Node{box, cut[c], cut[c + 1]};
        }
    }
}

static void visit(const Mesh& mesh, const IntersectionRay& ray, size_t index, Intersection& best)
{
    const auto& nodes = mesh.getBVH().getNodes();
    if (!intersect(nodes[index].bounds, ray))
        return;
    if (2 * index + 1 >= nodes.size() || nodes[2 * index + 1].facesEnd == 0) {
        for (uint32_t f : mesh.getBVH().getFaceIndices(nodes[index])) {
            Intersection hit = intersect(mesh.getTriangleFromFaceIndex(f), ray);
            if (hit.t < best.t)
                best = hit;
        }
        return;
    }
    visit(mesh, ray, 2 * index + 1, best);
    visit(mesh, ray, 2 * index + 2, best);
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    if (!mesh.getBVH().getNodes().empty())
        visit(mesh, ray, 0, best);
    return best;
}
