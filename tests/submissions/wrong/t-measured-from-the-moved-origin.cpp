// expect: hits.closest-wins
// untouched: a
// mistake: The ray is moved to its t_min before the traversal and t is counted from there.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
using namespace std;

void BVH::construct(const Mesh& mesh)
{
    int n = (int)mesh.getFaces().size();
    nodes.clear();
    faceIndices.resize(n);
    for (int i = 0; i < n; i++) faceIndices[i] = i;
    nodes.push_back({mesh.getBounds(), 0, (uint32_t)n});
    queue<pair<int, int>> q;
    q.push(make_pair(0, 0));
    while (!q.empty()) {
        int cur = q.front().first, depth = q.front().second;
        q.pop();
        int lo = nodes[cur].facesBegin, hi = nodes[cur].facesEnd, mid = (lo + hi) / 2;
        if (hi - lo <= (int)numFacesPerLeaf || depth >= (int)maxDepth) continue;
        int dim = nodes[cur].bounds.extents().maxDimension();
        auto cmp = [&](uint32_t a, uint32_t b) {
            Triangle A = mesh.getTriangleFromFaceIndex(a), B = mesh.getTriangleFromFaceIndex(b);
            return ((A.v1 + A.v2 + A.v3) / 3.f)[dim] < ((B.v1 + B.v2 + B.v3) / 3.f)[dim];
        };
        nth_element(faceIndices.begin() + lo, faceIndices.begin() + mid, faceIndices.begin() + hi, cmp);
        if ((int)nodes.size() < 2 * cur + 3) nodes.resize(2 * cur + 3);
        int from[3] = {lo, mid, hi};
        for (int c = 0; c < 2; c++) {
            AABB box;
            for (int k = from[c]; k < from[c + 1]; k++) {
                Triangle t = mesh.getTriangleFromFaceIndex(faceIndices[k]);
                box.min = min(min(box.min, t.v1), min(t.v2, t.v3));
                box.max = max(max(box.max, t.v1), max(t.v2, t.v3));
            }
            nodes[2 * cur + 1 + c] = {box, (uint32_t)from[c], (uint32_t)from[c + 1]};
            q.push(make_pair(2 * cur + 1 + c, depth + 1));
        }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    Ray moved = ray;
    moved.origin = ray.origin + ray.direction * ray.t_min;
    moved.t_min = 0;
    moved.t_max = ray.t_max - ray.t_min;
    const IntersectionRay rest(moved);
    const vector<BVH::Node>& nodes = mesh.getBVH().getNodes();
    stack<int> s;
    if (nodes.size() > 0) s.push(0);
    while (!s.empty()) {
        int i = s.top();
        s.pop();
        if (!intersect(nodes[i].bounds, rest)) continue;
        int l = 2 * i + 1, r = 2 * i + 2;
        if (r < (int)nodes.size() && nodes[l].facesEnd > 0) {
            int dim = nodes[i].bounds.extents().maxDimension();
            if (ray.direction[dim] < 0) swap(l, r);
            s.push(r);
            s.push(l);
        } else {
            for (uint32_t f : mesh.getBVH().getFaceIndices(nodes[i])) {
                Intersection x = intersect(mesh.getTriangleFromFaceIndex(f), rest);
                if (x && (!best || x.t < best.t)) best = x;
            }
        }
    }
    return best;
}
