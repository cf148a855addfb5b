// expect: hits.closest-wins
// untouched: a
// mistake: Children are looked for up to nodes.capacity(), where there may be old ones.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "triangle.h"

void BVH::construct(const Mesh& mesh)
{
    const uint32_t numFaces = uint32_t(mesh.getFaces().size());
    std::vector<Point3D> centre(numFaces);
    faceIndices.resize(numFaces);
    for (uint32_t f = 0; f < numFaces; ++f) {
        const Triangle t = mesh.getTriangleFromFaceIndex(f);
        centre[f] = (t.v1 + t.v2 + t.v3) / 3.0f;
        faceIndices[f] = f;
    }
    nodes.assign(1, Node{mesh.getBounds(), 0, numFaces});

    struct Job { size_t node; uint32_t depth; };
    std::queue<Job> jobs;
    jobs.push({0, 0});
    while (!jobs.empty()) {
        const Job job = jobs.front();
        jobs.pop();
        const Node node = nodes[job.node];
        const uint32_t count = node.facesEnd - node.facesBegin;
        if (count <= numFacesPerLeaf || job.depth == maxDepth)
            continue;
        const uint32_t middle = node.facesBegin + count / 2;
        const int axis = node.bounds.extents().maxDimension();
        std::nth_element(faceIndices.begin() + node.facesBegin, faceIndices.begin() + middle,
                         faceIndices.begin() + node.facesEnd, [&](uint32_t a, uint32_t b) {
                             return centre[a][axis] < centre[b][axis];
                         });
        Node halves[2] = {{AABB{}, node.facesBegin, middle}, {AABB{}, middle, node.facesEnd}};
        for (Node& half : halves)
            for (const uint32_t f : getFaceIndices(half)) {
                const Triangle t = mesh.getTriangleFromFaceIndex(f);
                half.bounds.extend(t.v1);
                half.bounds.extend(t.v2);
                half.bounds.extend(t.v3);
            }
        if (nodes.size() < 2 * job.node + 3)
            nodes.resize(2 * job.node + 3);
        nodes[2 * job.node + 1] = halves[0];
        nodes[2 * job.node + 2] = halves[1];
        jobs.push({2 * job.node + 1, job.depth + 1});
        jobs.push({2 * job.node + 2, job.depth + 1});
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    const std::vector<BVH::Node>& nodes = mesh.getBVH().getNodes();
    Intersection best;
    std::vector<size_t> open;
    if (!nodes.empty())
        open.push_back(0);
    while (!open.empty()) {
        const size_t i = open.back();
        open.pop_back();
        if (!intersect(nodes[i].bounds, ray))
            continue;
        const bool inner = 2 * i + 2 < nodes.capacity() && nodes[2 * i + 1].facesEnd > 0;
        if (inner) {
            open.push_back(2 * i + 2);
            open.push_back(2 * i + 1);
            continue;
        }
        for (const uint32_t f : mesh.getBVH().getFaceIndices(nodes[i])) {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(f), ray);
            if (hit.t < best.t)
                best = hit;
        }
    }
    return best;
}
