// right: room for all 2^21 - 1 nodes that maxDepth allows, at once and for every mesh; a bit per level says which half is still to do
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

void BVH::construct(const Mesh& mesh)
{
    const uint32_t numFaces = mesh.getFaces().size();

    nodes.clear();
    faceIndices.clear();
    nodes.resize((1u << (maxDepth + 1)) - 1); // a full tree has 2^(depth+1)-1 nodes
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);

    nodes[0].bounds = mesh.getBounds();
    nodes[0].facesBegin = 0;
    nodes[0].facesEnd = numFaces;

    // every node that has children
    const uint32_t numInner = (1u << maxDepth) - 1;
    for (uint32_t i = 0; i < numInner; i++)
    {
        Node& node = nodes[i];
        const uint32_t numFacesInNode = node.facesEnd - node.facesBegin;
        if (numFacesInNode <= numFacesPerLeaf)
            continue;

        Node& left = nodes[2 * i + 1];
        Node& right = nodes[2 * i + 2];

        const uint8_t axis = node.bounds.extents().maxDimension();
        std::span<uint32_t> indices = getFaceIndices(node);
        auto median = indices.begin() + indices.size() / 2;
        std::nth_element(indices.begin(), median, indices.end(), [&mesh, axis](const uint32_t& lhs, const uint32_t& rhs) {
            const Triangle l = mesh.getTriangleFromFaceIndex(lhs);
            const Triangle r = mesh.getTriangleFromFaceIndex(rhs);
            const Point3D triangleCenterL = l.v1 / 3 + l.v2 / 3 + l.v3 / 3;
            const Point3D triangleCenterR = r.v1 / 3 + r.v2 / 3 + r.v3 / 3;
            return triangleCenterL[axis] < triangleCenterR[axis];
        });

        left.facesBegin = node.facesBegin;
        left.facesEnd = node.facesBegin + numFacesInNode / 2;
        right.facesBegin = left.facesEnd;
        right.facesEnd = node.facesEnd;

        for (Node* child : {&left, &right})
        {
            for (uint32_t index : getFaceIndices(*child))
            {
                const Triangle t = mesh.getTriangleFromFaceIndex(index);
                child->bounds.extend(t.v1);
                child->bounds.extend(t.v2);
                child->bounds.extend(t.v3);
            }
        }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    const BVH& bvh = mesh.getBVH();
    const std::vector<BVH::Node>& nodes = bvh.getNodes();

    Intersection best;
    if (nodes.empty())
        return best;

    // bit d of the trail is set if the right child at depth d is still to be visited
    uint64_t trail = 0;
    uint32_t depth = 0;
    uint64_t i = 0;
    while (true)
    {
        if (intersect(nodes[i].bounds, ray))
        {
            const uint64_t left = 2 * i + 1;
            const bool isLeaf = left >= nodes.size() || nodes[left].facesEnd == 0;
            if (!isLeaf)
            {
                ++depth;
                trail |= uint64_t(1) << depth;
                i = left;
                continue;
            }
            for (uint32_t index : bvh.getFaceIndices(nodes[i]))
            {
                const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(index), ray);
                if (hit.t < best.t)
                    best = hit;
            }
        }
        if (trail == 0)
            return best;
        // go up to the deepest level with a right child left, then to that child
        const uint32_t target = 63 - std::countl_zero(trail);
        i = ((i + 1) >> (depth - target)) - 1;
        i += 1;
        trail &= ~(uint64_t(1) << target);
        depth = target;
    }
}
