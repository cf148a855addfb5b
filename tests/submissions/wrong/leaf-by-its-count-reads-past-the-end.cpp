// expect: hits.memory-is-safe
// untouched: a
// mistake: A node is a leaf if it holds at most four faces; its children are not asked for.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "triangle.h"

#include <utility>
#include <vector>

static void quickselect(uint32_t* faces, long count, long k, const std::vector<double>& key)
{
    long low = 0, high = count - 1;
    while (low < high) {
        const double pivot = key[faces[low + (high - low) / 2]];
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

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    Intersection best;
    std::vector<uint32_t> todo;
    if (!nodes.empty())
        todo.push_back(0);
    while (!todo.empty()) {
        const uint32_t i = todo.back();
        todo.pop_back();
        const bool leaf = nodes[i].facesEnd - nodes[i].facesBegin <= BVH::numFacesPerLeaf;
        if (leaf) {  // the triangles are tested at once, the leaf's own box is not worth it
            for (uint32_t face : bvh.getFaceIndices(nodes[i])) {
                const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
                if (hit.t < best.t)
                    best = hit;
            }
        } else if (intersect(nodes[i].bounds, ray)) {
            todo.push_back(2 * i + 1);
            todo.push_back(2 * i + 2);
        }
    }
    return best;
}
