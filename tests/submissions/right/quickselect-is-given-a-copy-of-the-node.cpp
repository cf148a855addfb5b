// right: a recursive quickselect as the sorting helper is given its node by value, beside a vector of records
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

struct Item {
    Point3D center;
    uint32_t face;
};

// Partially sorts items[lo..hi] of a node along the longest side of its box, until items[k] is in its place.
void quickSelect(std::vector<Item>& items, BVH::Node node, int64_t lo, int64_t hi, int64_t k)
{
    if (lo >= hi)
        return;
    int axis = node.bounds.extents().maxDimension();
    float pivot = items[lo + (hi - lo) / 2].center[axis];
    int64_t i = lo, j = hi;
    while (i <= j)
    {
        while (items[i].center[axis] < pivot) i++;
        while (items[j].center[axis] > pivot) j--;
        if (i <= j)
        {
            std::swap(items[i], items[j]);
            i++;
            j--;
        }
    }
    if (k <= j)
        quickSelect(items, node, lo, j, k);
    if (k >= i)
        quickSelect(items, node, i, hi, k);
}

AABB boxOfFaces(const Mesh& mesh, const std::vector<Item>& items, uint32_t begin, uint32_t end)
{
    AABB box;
    for (uint32_t k = begin; k < end; k++)
    {
        Triangle t = mesh.getTriangleFromFaceIndex(items[k].face);
        box.extend(t.v1);
        box.extend(t.v2);
        box.extend(t.v3);
    }
    return box;
}

void BVH::construct(const Mesh& mesh)
{
    uint32_t numFaces = (uint32_t)mesh.getFaces().size();
    std::vector<Item> items;
    for (uint32_t f = 0; f < numFaces; f++)
    {
        Triangle t = mesh.getTriangleFromFaceIndex(f);
        items.push_back({(t.v1 + t.v2 + t.v3) / 3.0f, f});
    }

    nodes.clear();
    nodes.push_back(Node{mesh.getBounds(), 0, numFaces});

    std::queue<std::pair<size_t, uint32_t>> todo; // node and depth
    todo.push({0, 0});
    while (!todo.empty())
    {
        size_t i = todo.front().first;
        uint32_t depth = todo.front().second;
        todo.pop();

        Node node = nodes[i];
        uint32_t count = node.facesEnd - node.facesBegin;
        if (count <= numFacesPerLeaf || depth >= maxDepth)
            continue;

        uint32_t mid = node.facesBegin + count / 2;
        quickSelect(items, node, node.facesBegin, (int64_t)node.facesEnd - 1, mid);

        Node left = {boxOfFaces(mesh, items, node.facesBegin, mid), node.facesBegin, mid};
        Node right = {boxOfFaces(mesh, items, mid, node.facesEnd), mid, node.facesEnd};
        if (nodes.size() < 2 * i + 3)
            nodes.resize(2 * i + 3);
        nodes[2 * i + 1] = left;
        nodes[2 * i + 2] = right;
        todo.push({2 * i + 1, depth + 1});
        todo.push({2 * i + 2, depth + 1});
    }

    faceIndices.clear();
    for (Item item : items)
        faceIndices.push_back(item.face);
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    const BVH& bvh = mesh.getBVH();
    const std::vector<BVH::Node>& nodes = bvh.getNodes();
    Intersection closest;
    std::queue<size_t> todo;
    if (!nodes.empty())
        todo.push(0);
    while (!todo.empty())
    {
        size_t i = todo.front();
        todo.pop();
        if (!intersect(nodes[i].bounds, ray))
            continue;
        bool leaf = 2 * i + 2 >= nodes.size() || nodes[2 * i + 1].facesEnd == 0;
        if (!leaf)
        {
            todo.push(2 * i + 1);
            todo.push(2 * i + 2);
            continue;
        }
        for (uint32_t face : bvh.getFaceIndices(nodes[i]))
        {
            Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
            if (hit.t < closest.t)
                closest = hit;
        }
    }
    return closest;
}
