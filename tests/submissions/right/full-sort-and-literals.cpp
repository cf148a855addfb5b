// right: the obvious way: std::sort of every node's faces by the centre of a Triangle, and the literals 4 and 20
#include "mesh.h"
#include "bvh.h"
#include "intersection.h"
#include <stack>

// getrennte Funktion, damit es lesbar bleibt
static float triangleCenter(const Triangle& t, int dim)
{
    return (t.v1[dim] + t.v2[dim] + t.v3[dim]) / 3.0f;
}

void BVH::construct(const Mesh& mesh)
{
    uint32_t n = mesh.getFaces().size();
    nodes.clear();
    faceIndices.clear();
    for (uint32_t i = 0; i < n; i++) faceIndices.push_back(i);
    nodes.push_back(Node{mesh.getBounds(), 0, n});

    uint32_t i = 0;
    for (int level = 0; level < 20; level++)
    {
        uint32_t end = i + (1u << level);
        for (; i < end; i++)
        {
            if (i >= nodes.size() || nodes[i].facesEnd - nodes[i].facesBegin <= 4)
                continue;
            Node node = nodes[i];
            Vector3D e = node.bounds.extents();
            int dim = 0;
            if (e.y > e.x) dim = 1;
            if (e.z > e[dim]) dim = 2;

            std::span<uint32_t> faces = getFaceIndices(node);
            std::sort(faces.begin(), faces.end(), [&](uint32_t a, uint32_t b) {
                return triangleCenter(mesh.getTriangleFromFaceIndex(a), dim) < triangleCenter(mesh.getTriangleFromFaceIndex(b), dim);
            });

            uint32_t middle = node.facesBegin + (node.facesEnd - node.facesBegin + 1) / 2;
            Node left, right;
            left.facesBegin = node.facesBegin;
            left.facesEnd = middle;
            right.facesBegin = middle;
            right.facesEnd = node.facesEnd;
            for (uint32_t f : getFaceIndices(left))
            {
                Triangle t = mesh.getTriangleFromFaceIndex(f);
                left.bounds.extend(t.v1); left.bounds.extend(t.v2); left.bounds.extend(t.v3);
            }
            for (uint32_t f : getFaceIndices(right))
            {
                Triangle t = mesh.getTriangleFromFaceIndex(f);
                right.bounds.extend(t.v1); right.bounds.extend(t.v2); right.bounds.extend(t.v3);
            }
            if (nodes.size() < 2 * i + 3)
                nodes.resize(2 * i + 3);
            nodes[2 * i + 1] = left;
            nodes[2 * i + 2] = right;
        }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection closest;
    const BVH& bvh = mesh.getBVH();
    std::stack<uint32_t> todo;
    todo.push(0);
    while (!todo.empty())
    {
        uint32_t i = todo.top();
        todo.pop();
        if (i >= bvh.getNodes().size())
            continue;
        const BVH::Node& node = bvh.getNodes()[i];
        if (!intersect(node.bounds, ray))
            continue;
        bool leaf = 2 * i + 1 >= bvh.getNodes().size() || bvh.getNodes()[2 * i + 1].facesEnd == 0;
        if (leaf)
        {
            for (uint32_t f : bvh.getFaceIndices(node))
            {
                Intersection hit = intersect(mesh.getTriangleFromFaceIndex(f), ray);
                if (hit.t < closest.t)
                    closest = hit;
            }
        }
        else
        {
            todo.push(2 * i + 2);
            todo.push(2 * i + 1);
        }
    }
    return closest;
}
