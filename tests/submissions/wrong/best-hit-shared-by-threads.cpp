// expect: hits.calls-are-independent
// untouched: a
// mistake: The best hit is a global variable, reset for every ray but shared by threads.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"
#include "triangle.h"

#include <bit>
#include <cmath>
#include <vector>

void BVH::construct(const Mesh& mesh)
{
    nodes.clear();
    faceIndices.clear();
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    if (numFaces == 0)
        return;
    for (uint32_t i = 0; i < numFaces; ++i)
        faceIndices.push_back(i);
    nodes.push_back({mesh.getBounds(), 0, numFaces});

    auto makeNode = [&](uint32_t begin, uint32_t end) {
        Node node{{}, begin, end};
        for (auto face : getFaceIndices(node)) {
            auto triangle = mesh.getTriangleFromFaceIndex(face);
            node.bounds.extend(triangle.v1);
            node.bounds.extend(triangle.v2);
            node.bounds.extend(triangle.v3);
        }
        return node;
    };

    size_t levelBegin = 0;
    for (uint32_t depth = 0; depth < maxDepth; ++depth) {
        const size_t levelEnd = nodes.size();
        bool split = false;
        for (size_t i = levelBegin; i < levelEnd; ++i) {
            const Node node = nodes[i];
            if (node.facesEnd - node.facesBegin <= numFacesPerLeaf) {
                nodes.push_back(Node{});
                nodes.push_back(Node{});
                continue;
            }
            split = true;
            const uint32_t mid = node.facesBegin + (node.facesEnd - node.facesBegin) / 2;
            const uint8_t axis = node.bounds.extents().maxDimension();
            auto faces = getFaceIndices(node);
            std::nth_element(faces.begin(), faces.begin() + (mid - node.facesBegin), faces.end(),
                             [&](uint32_t a, uint32_t b) {
                                 auto s = mesh.getTriangleFromFaceIndex(a);
                                 auto t = mesh.getTriangleFromFaceIndex(b);
                                 const auto sum = [](const Triangle& x) { return x.v1 + x.v2 + x.v3; };
                                 return sum(s)[axis] < sum(t)[axis];
                             });
            nodes.push_back(makeNode(node.facesBegin, mid));
            nodes.push_back(makeNode(mid, node.facesEnd));
        }
        levelBegin = levelEnd;
        if (!split)
            break;
    }
    while (nodes.back().facesEnd == 0)
        nodes.pop_back();
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

static Intersection best;

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    best = {};
    if (!mesh.getBVH().getNodes().empty())
        visit(mesh, ray, 0, best);
    return best;
}
