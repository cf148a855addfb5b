// expect: bvh.splits-the-longest-axis
// untouched: b
// mistake: The extents are compared as whole numbers.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

void BVH::construct(const Mesh& mesh)
{
    uint32_t n = static_cast<uint32_t>(mesh.getFaces().size()), i = 0, b, e, m;
    nodes.assign(1, {mesh.getBounds(), 0, n});
    faceIndices.resize(n);
    while (i < n) faceIndices[i] = i, ++i;
    i = 0;
    do {
        b = nodes[i].facesBegin, e = nodes[i].facesEnd, m = b + (e - b) / 2;
        const Vector3D s = nodes[i].bounds.extents();
        const size_t a = int(s.x) >= int(s.y) ? (int(s.x) >= int(s.z) ? 0 : 2) : (int(s.y) >= int(s.z) ? 1 : 2);
        if (!(i >= (1u << maxDepth) - 1 || e - b <= numFacesPerLeaf)) {
            std::nth_element(faceIndices.begin() + b, faceIndices.begin() + m, faceIndices.begin() + e, [&](uint32_t p, uint32_t q) {
                const Triangle t = mesh.getTriangleFromFaceIndex(p), u = mesh.getTriangleFromFaceIndex(q);
                const float x = (t.v1[a] + t.v2[a] + t.v3[a]) / 3, y = (u.v1[a] + u.v2[a] + u.v3[a]) / 3;
                return x < y ? true : x > y ? false : p < q;
            });
            nodes.size() < 2 * size_t(i) + 3 ? nodes.resize(2 * size_t(i) + 3) : void();
            nodes[2 * i + 1] = {{}, b, m};
            nodes[2 * i + 2] = {{}, m, e};
            for (uint32_t k = b; k < e; ++k) {
                const Triangle t = mesh.getTriangleFromFaceIndex(faceIndices[k]);
                (k < m ? nodes[2 * i + 1] : nodes[2 * i + 2]).bounds.extend(AABB{min(t.v1, min(t.v2, t.v3)), max(t.v1, max(t.v2, t.v3))});
            }
        }
    } while (++i < nodes.size());
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    const auto& N = mesh.getBVH().getNodes();
    int stack[100], top = N.empty() ? -1 : 0;
    stack[0] = 0;
    while (top >= 0) {
        const int i = stack[top--], l = 2 * i + 1, r = 2 * i + 2;
        const bool hit = intersect(N[i].bounds, ray), leaf = r >= int(N.size()) || !N[l].facesEnd || !N[r].facesEnd;
        if (hit && !leaf) stack[++top] = r, stack[++top] = l;
        else if (hit)
            for (uint32_t f : mesh.getBVH().getFaceIndices(N[i])) {
                const Intersection x = intersect(mesh.getTriangleFromFaceIndex(f), ray);
                best = x.t < best.t ? x : best;
            }
    }
    return best;
}
