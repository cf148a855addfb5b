// right: "#define private public" so that free helpers reach the nodes; std::multimap as the sorted list of centres
#include <algorithm>
#include <functional>
#include <map>
#include <sstream>
#define private public
#include "bvh.h"
#undef private
#include "intersection.h"
#include "mesh.h"

static void sortAlongAxis(BVH& bvh, const Mesh& mesh, size_t node, uint8_t axis)
{
    std::multimap<float, uint32_t> sorted;
    for (uint32_t face : bvh.getFaceIndices(bvh.nodes[node])) {
        const Triangle t = mesh.getTriangleFromFaceIndex(face);
        sorted.insert({(t.v1[axis] + t.v2[axis] + t.v3[axis]) / 3, face});
    }
    uint32_t k = bvh.nodes[node].facesBegin;
    for (const auto& [center, face] : sorted)
        bvh.faceIndices[k++] = face;
}

static void addChild(BVH& bvh, const Mesh& mesh, size_t node, uint32_t begin, uint32_t end)
{
    if (bvh.nodes.size() <= node)
        bvh.nodes.resize(node + 1);
    bvh.nodes[node] = {AABB(), begin, end};
    for (uint32_t face : bvh.getFaceIndices(bvh.nodes[node])) {
        const Triangle t = mesh.getTriangleFromFaceIndex(face);
        bvh.nodes[node].bounds.extend(t.v1);
        bvh.nodes[node].bounds.extend(t.v2);
        bvh.nodes[node].bounds.extend(t.v3);
    }
}

static void splitNode(BVH& bvh, const Mesh& mesh, size_t node)
{
    const uint32_t begin = bvh.nodes[node].facesBegin;
    const uint32_t end = bvh.nodes[node].facesEnd;
    const uint32_t middle = begin + (end - begin) / 2;
    sortAlongAxis(bvh, mesh, node, bvh.nodes[node].bounds.extents().maxDimension());
    addChild(bvh, mesh, 2 * node + 1, begin, middle);
    addChild(bvh, mesh, 2 * node + 2, middle, end);
}

void BVH::construct(const Mesh& mesh)
{
    nodes.clear();
    faceIndices.clear();
    for (size_t i = 0; i < mesh.getFaces().size(); i++)
        faceIndices.push_back(i);
    nodes.push_back({mesh.getBounds(), 0, (uint32_t)faceIndices.size()});
    size_t nextLevel = 1, depth = 0;
    for (size_t node = 0; node < nodes.size(); node++) {
        if (node == nextLevel) {
            nextLevel = 2 * nextLevel + 1;
            depth++;
        }
        if (depth < maxDepth && nodes[node].facesEnd - nodes[node].facesBegin > numFacesPerLeaf)
            splitNode(*this, mesh, node);
    }
}

static Intersection nearer(const Intersection& a, const Intersection& b) { return b.t < a.t ? b : a; }

static Intersection intersectNode(const Mesh& mesh, const IntersectionRay& ray, size_t i)
{
    const BVH& bvh = mesh.getBVH();
    const BVH::Node& node = bvh.nodes[i];
    Intersection best;
    if (!intersect(node.bounds, ray))
        return best;
    if (2 * i + 1 >= bvh.nodes.size() || bvh.nodes[2 * i + 1].facesEnd == 0) {
        for (uint32_t k = node.facesBegin; k < node.facesEnd; k++)
            best = nearer(best, intersect(mesh.getTriangleFromFaceIndex(bvh.faceIndices[k]), ray));
        return best;
    }
    return nearer(intersectNode(mesh, ray, 2 * i + 1), intersectNode(mesh, ray, 2 * i + 2));
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    return mesh.getBVH().nodes.empty() ? Intersection{} : intersectNode(mesh, ray, 0);
}
