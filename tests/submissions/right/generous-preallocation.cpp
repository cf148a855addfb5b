// right: one slot for every face and more (roundUpPowerOfTwo of the faces), std::function recursion in intersect
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "triangle.h"

#include <functional>

struct Todo
{
    uint32_t index;
    uint32_t depth;
};

void BVH::construct(const Mesh& mesh)
{
    const uint32_t numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    nodes = std::vector<Node>(roundUpPowerOfTwo(numFaces));
    faceIndices = std::vector<uint32_t>(numFaces);
    for (uint32_t i = 0; i < numFaces; i++)
    {
        faceIndices[i] = i;
    }
    nodes[0].facesEnd = numFaces;
    nodes[0].bounds = mesh.getBounds();

    std::stack<Todo> todo;
    todo.push(Todo{0, 1});
    while (!todo.empty())
    {
        const Todo current = todo.top();
        todo.pop();
        const Node& node = nodes[current.index];
        const std::span<uint32_t> faces = getFaceIndices(node);
        if (current.depth > maxDepth || faces.size() <= numFacesPerLeaf)
        {
            continue;
        }
        const size_t half = faces.size() / 2;
        const uint8_t dim = node.bounds.extents().maxDimension();
        std::nth_element(faces.begin(), faces.begin() + half, faces.end(), [&mesh, dim](const uint32_t& a, const uint32_t& b) {
            const Triangle ta = mesh.getTriangleFromFaceIndex(a);
            const Triangle tb = mesh.getTriangleFromFaceIndex(b);
            const Point3D ca = ta.v1 / 3.0f + ta.v2 / 3.0f + ta.v3 / 3.0f;
            const Point3D cb = tb.v1 / 3.0f + tb.v2 / 3.0f + tb.v3 / 3.0f;
            return ca[dim] < cb[dim];
        });

        Node& left = nodes[2 * current.index + 1];
        Node& right = nodes[2 * current.index + 2];
        left.facesBegin = node.facesBegin;
        left.facesEnd = node.facesBegin + static_cast<uint32_t>(half);
        right.facesBegin = left.facesEnd;
        right.facesEnd = node.facesEnd;
        for (Node* child : {&left, &right})
        {
            for (const uint32_t& faceIndex : getFaceIndices(*child))
            {
                const Triangle triangle = mesh.getTriangleFromFaceIndex(faceIndex);
                child->bounds.extend(triangle.v1);
                child->bounds.extend(triangle.v2);
                child->bounds.extend(triangle.v3);
            }
        }
        todo.push(Todo{2 * current.index + 1, current.depth + 1});
        todo.push(Todo{2 * current.index + 2, current.depth + 1});
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    const BVH& bvh = mesh.getBVH();
    const std::function<void(size_t)> visit = [&](size_t i)
    {
        const BVH::Node& node = bvh.getNodes()[i];
        if (!intersect(node.bounds, ray))
        {
            return;
        }
        if (2 * i + 2 < bvh.getNodes().size() && bvh.getNodes()[2 * i + 1].facesEnd != 0)
        {
            visit(2 * i + 1);
            visit(2 * i + 2);
            return;
        }
        for (const uint32_t& faceIndex : bvh.getFaceIndices(node))
        {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(faceIndex), ray);
            if (hit.t < best.t)
            {
                best = hit;
            }
        }
    };
    if (!bvh.getNodes().empty())
    {
        visit(0);
    }
    return best;
}
