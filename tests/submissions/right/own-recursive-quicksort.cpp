// right: an own recursive quicksort as the sorting helper (the loop over the nodes is none of its business)
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "triangle.h"

#include <stack>

namespace
{
    float centerAlong(const Mesh& mesh, uint32_t face, int axis)
    {
        const Triangle t = mesh.getTriangleFromFaceIndex(face);
        return (t.v1[axis] + t.v2[axis] + t.v3[axis]) / 3.0f;
    }

    void quicksort(std::vector<uint32_t>& faces, int first, int last, const Mesh& mesh, int axis)
    {
        if (first >= last)
            return;
        const float pivot = centerAlong(mesh, faces[first + (last - first) / 2], axis);
        int i = first - 1, j = last + 1;
        while (true) {
            do ++i; while (centerAlong(mesh, faces[i], axis) < pivot);
            do --j; while (centerAlong(mesh, faces[j], axis) > pivot);
            if (i >= j)
                break;
            std::swap(faces[i], faces[j]);
        }
        quicksort(faces, first, j, mesh, axis);
        quicksort(faces, j + 1, last, mesh, axis);
    }
}

void BVH::construct(const Mesh& mesh)
{
    const int numFaces = static_cast<int>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    for (int i = 0; i < numFaces; ++i)
        faceIndices[i] = i;
    nodes.clear();
    nodes.push_back(Node{mesh.getBounds(), 0, static_cast<uint32_t>(numFaces)});

    std::stack<std::pair<int, uint32_t>> work;
    work.emplace(0, 0);
    while (!work.empty()) {
        auto [index, depth] = work.top();
        work.pop();
        Node node = nodes[index];
        if (node.facesEnd - node.facesBegin <= numFacesPerLeaf || depth >= maxDepth)
            continue;
        quicksort(faceIndices, node.facesBegin, int(node.facesEnd) - 1, mesh, node.bounds.extents().maxDimension());
        const uint32_t middle = (node.facesBegin + node.facesEnd) / 2;
        if (nodes.size() < size_t(2 * index + 3))
            nodes.resize(2 * index + 3);
        nodes[2 * index + 1] = Node{AABB{}, node.facesBegin, middle};
        nodes[2 * index + 2] = Node{AABB{}, middle, node.facesEnd};
        for (int child = 2 * index + 1; child <= 2 * index + 2; ++child) {
            for (uint32_t face : getFaceIndices(nodes[child])) {
                Triangle t = mesh.getTriangleFromFaceIndex(face);
                nodes[child].bounds.extend(t.v1);
                nodes[child].bounds.extend(t.v2);
                nodes[child].bounds.extend(t.v3);
            }
            work.emplace(child, depth + 1);
        }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    if (!mesh.getBVH().isConstructed() || mesh.getFaces().empty())
        return best;
    const auto& nodes = mesh.getBVH().getNodes();
    std::stack<int> work;
    work.push(0);
    while (!work.empty()) {
        const size_t left = 2 * size_t(work.top()) + 1;
        const BVH::Node& node = nodes[work.top()];
        work.pop();
        if (!intersect(node.bounds, ray))
            continue;
        if (left + 1 >= nodes.size() || (nodes[left].facesEnd == 0 && nodes[left + 1].facesEnd == 0)) {
            for (uint32_t face : mesh.getBVH().getFaceIndices(node)) {
                Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
                best = hit.t < best.t ? hit : best;
            }
        } else {
            work.push(left);
            work.push(left + 1);
        }
    }
    return best;
}
