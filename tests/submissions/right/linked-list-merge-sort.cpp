// right: recursive merge sort of a linked list whose elements are called Node, too; a linked list as the queue of intersect
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <list>

// Own list for sorting: one Node per face
struct Node
{
    float key;
    uint32_t face;
    Node* next;
};

static Node* merge(Node* a, Node* b)
{
    Node head = {0, 0, nullptr};
    Node* tail = &head;
    while (a != nullptr && b != nullptr)
    {
        Node*& smaller = b->key < a->key ? b : a;
        tail->next = smaller;
        tail = smaller;
        smaller = smaller->next;
    }
    tail->next = a != nullptr ? a : b;
    return head.next;
}

// Recursive, as in the lecture on sorting
static Node* mergeSort(Node* head)
{
    if (head == nullptr || head->next == nullptr)
        return head;
    Node* slow = head;
    for (Node* fast = head->next; fast != nullptr && fast->next != nullptr; fast = fast->next->next)
        slow = slow->next;
    Node* second = slow->next;
    slow->next = nullptr;
    return merge(mergeSort(head), mergeSort(second));
}

static void sortFaces(std::span<uint32_t> faces, const Mesh& mesh, int axis)
{
    std::vector<Node> list(faces.size());
    for (size_t k = 0; k < faces.size(); k++)
    {
        const Triangle t = mesh.getTriangleFromFaceIndex(faces[k]);
        list[k].key = t.v1[axis] + t.v2[axis] + t.v3[axis]; // the sum sorts like the mean
        list[k].face = faces[k];
        list[k].next = k + 1 < faces.size() ? &list[k + 1] : nullptr;
    }
    size_t k = 0;
    for (Node* node = mergeSort(list.data()); node != nullptr; node = node->next)
        faces[k++] = node->face;
}

void BVH::construct(const Mesh& mesh)
{
    const uint32_t numFaces = (uint32_t)mesh.getFaces().size();
    nodes.clear();
    nodes.push_back({mesh.getBounds(), 0, numFaces});
    faceIndices.clear();
    for (uint32_t f = 0; f < numFaces; f++)
        faceIndices.push_back(f);

    std::list<std::pair<size_t, uint32_t>> todo;
    todo.push_back({0, 0});
    while (!todo.empty())
    {
        const auto [i, depth] = todo.front();
        todo.pop_front();
        const uint32_t begin = nodes[i].facesBegin, end = nodes[i].facesEnd;
        if (end - begin <= numFacesPerLeaf || depth >= maxDepth)
            continue;
        sortFaces(getFaceIndices(nodes[i]), mesh, nodes[i].bounds.extents().maxDimension());
        const uint32_t middle = begin + (end - begin) / 2;
        while (nodes.size() < 2 * i + 3)
            nodes.push_back(BVH::Node());
        nodes[2 * i + 1].facesBegin = begin;
        nodes[2 * i + 1].facesEnd = nodes[2 * i + 2].facesBegin = middle;
        nodes[2 * i + 2].facesEnd = end;
        for (size_t child = 2 * i + 1; child <= 2 * i + 2; child++)
        {
            for (uint32_t face : getFaceIndices(nodes[child]))
            {
                const Triangle t = mesh.getTriangleFromFaceIndex(face);
                nodes[child].bounds.extend(t.v1);
                nodes[child].bounds.extend(t.v2);
                nodes[child].bounds.extend(t.v3);
            }
            todo.push_back({child, depth + 1});
        }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection result;
    const BVH& bvh = mesh.getBVH();
    const std::vector<BVH::Node>& nodes = bvh.getNodes();
    std::list<size_t> todo;
    if (nodes.size() > 0)
        todo.push_back(0);
    while (todo.size() > 0)
    {
        const size_t i = todo.front();
        todo.pop_front();
        if (!intersect(nodes[i].bounds, ray))
            continue;
        if (2 * i + 1 >= nodes.size() || nodes[2 * i + 1].facesEnd == 0)
        {
            for (uint32_t face : bvh.getFaceIndices(nodes[i]))
            {
                const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
                if (hit.t < result.t)
                    result = hit;
            }
        }
        else
        {
            todo.push_back(2 * i + 1);
            todo.push_back(2 * i + 2);
        }
    }
    return result;
}
