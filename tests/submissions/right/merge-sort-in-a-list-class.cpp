// right: a class for linked lists with its own nested Node sorts faces by a recursive merge sort, a static member
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

class FaceList {
  public:
    explicit FaceList(size_t most) { room.reserve(most); }

    void fill(std::span<const uint32_t> faces, const std::vector<Point3D>& centres, size_t axis) {
        room.clear();
        for (const uint32_t face : faces)
            room.push_back({centres[face][axis], face, nullptr});
        for (size_t k = 0; k + 1 < room.size(); ++k)
            room[k].next = &room[k + 1];
        first = mergeSort(room.data(), room.size());
    }

    void writeTo(std::span<uint32_t> faces) const {
        const Node* each = first;
        for (uint32_t& face : faces) {
            face = each->face;
            each = each->next;
        }
    }

  private:
    struct Node {
        float key;
        uint32_t face;
        Node* next;
    };

    static Node* mergeSort(Node* list, size_t count) {
        if (count < 2) {
            list->next = nullptr;
            return list;
        }
        Node* second = list;
        for (size_t k = 0; k < count / 2; ++k)
            second = second->next;
        Node* a = mergeSort(list, count / 2);
        Node* b = mergeSort(second, count - count / 2);
        Node* merged = nullptr;
        Node** end = &merged;
        while (a && b) {
            Node*& smaller = b->key < a->key ? b : a;
            *end = smaller;
            smaller = smaller->next;
            end = &(*end)->next;
        }
        *end = a ? a : b;
        return merged;
    }

    std::vector<Node> room;
    Node* first = nullptr;
};

void BVH::construct(const Mesh& mesh) {
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.assign(1, Node{mesh.getBounds(), 0, numFaces});
    std::vector<Point3D> centres;
    for (uint32_t face = 0; face < numFaces; ++face) {
        const Triangle t = mesh.getTriangleFromFaceIndex(face);
        centres.push_back((t.v1 + t.v2 + t.v3) * (1.0f / 3.0f));
    }
    FaceList list(numFaces);
    for (size_t i = 0; i < nodes.size(); ++i) {
        const Node node = nodes[i];
        const uint32_t count = node.facesEnd - node.facesBegin;
        if (count <= numFacesPerLeaf || std::bit_width(i + 1) > maxDepth)
            continue;
        list.fill(getFaceIndices(node), centres, node.bounds.extents().maxDimension());
        list.writeTo(getFaceIndices(node));
        if (nodes.size() < 2 * i + 3)
            nodes.resize(2 * i + 3);
        const uint32_t middle = node.facesBegin + count / 2;
        const uint32_t cuts[] = {node.facesBegin, middle, node.facesEnd};
        for (size_t side = 0; side < 2; ++side) {
            Node& child = nodes[2 * i + 1 + side];
            child = {AABB{}, cuts[side], cuts[side + 1]};
            for (const uint32_t face : getFaceIndices(child)) {
                const Triangle t = mesh.getTriangleFromFaceIndex(face);
                for (const Point3D* corner : {&t.v1, &t.v2, &t.v3})
                    child.bounds.extend(*corner);
            }
        }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const auto& nodes = mesh.getBVH().getNodes();
    Intersection best;
    std::vector<size_t> open;
    if (!nodes.empty())
        open.push_back(0);
    while (!open.empty()) {
        const size_t i = open.back();
        open.pop_back();
        if (!intersect(nodes[i].bounds, ray))
            continue;
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 2].facesEnd != 0) {
            open.push_back(2 * i + 2);
            open.push_back(2 * i + 1);
            continue;
        }
        for (const uint32_t face : mesh.getBVH().getFaceIndices(nodes[i])) {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
            if (hit.t < best.t)
                best = hit;
        }
    }
    return best;
}
