// right: a main function for trying things out is still in the file; the loop counts levels by powers of two
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include <cstdio>

void BVH::construct(const Mesh& mesh) {
    *this = {};
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);
    nodes.push_back(Node{mesh.getBounds(), 0, numFaces});
    for (size_t i = 0, depth = 0; i < nodes.size(); ++i) {
        while (((size_t{1} << (depth + 1)) - 1) <= i) ++depth;
        const uint32_t b = nodes[i].facesBegin, e = nodes[i].facesEnd;
        if (e - b <= numFacesPerLeaf || depth >= maxDepth) continue;
        const int axis = nodes[i].bounds.extents().maxDimension();
        const uint32_t m = (b + e) / 2;
        std::nth_element(faceIndices.begin() + b, faceIndices.begin() + m, faceIndices.begin() + e,
            [&](uint32_t x, uint32_t y) { Triangle a = mesh.getTriangleFromFaceIndex(x), c = mesh.getTriangleFromFaceIndex(y); return ((a.v1 + a.v2 + a.v3) / 3)[axis] < ((c.v1 + c.v2 + c.v3) / 3)[axis]; });
        if (nodes.size() < 2 * i + 3) nodes.resize(2 * i + 3);
        for (int c = 0; c < 2; ++c) {
            Node n; n.facesBegin = c ? m : b; n.facesEnd = c ? e : m;
            AABB box;
            for (uint32_t k = n.facesBegin; k < n.facesEnd; ++k) { Triangle t = mesh.getTriangleFromFaceIndex(faceIndices[k]); box.extend(t.v1); box.extend(t.v2); box.extend(t.v3); }
            n.bounds = box; nodes[2 * i + 1 + c] = n;
        }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const BVH& bvh = mesh.getBVH(); const auto& nodes = bvh.getNodes();
    Intersection best; std::vector<size_t> todo{0};
    while (!todo.empty()) { size_t i = todo.back(); todo.pop_back();
        if (i >= nodes.size() || !intersect(nodes[i].bounds, ray)) continue;
        size_t l = 2*i+1, r = 2*i+2;
        bool leaf = r >= nodes.size() || nodes[l].facesEnd == 0 || nodes[r].facesEnd == 0;
        if (!leaf) { todo.push_back(l); todo.push_back(r); continue; }
        for (uint32_t f : bvh.getFaceIndices(nodes[i])) { auto h = intersect(mesh.getTriangleFromFaceIndex(f), ray); if (h.t < best.t) best = h; }
    }
    return best;
}

int main(int argc, char** argv) { std::printf("%d\n", argc); Mesh* m = nullptr; return m != nullptr; }
