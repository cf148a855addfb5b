// right: a std::priority_queue keeps the smaller half of the centres; a mutex guards the static stack of intersect
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <mutex>

struct FaceAtCenter {
    float center;
    uint32_t face;
    bool operator<(const FaceAtCenter& other) const { return center < other.center; }
};

void BVH::construct(const Mesh& mesh)
{
    uint32_t numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.clear();
    for (uint32_t i = 0; i < numFaces; ++i)
        faceIndices.emplace_back(i);
    nodes.clear();
    nodes.emplace_back(Node{mesh.getBounds(), 0, numFaces});

    uint32_t depth = 0;
    uint32_t nodesLeftOnLevel = 1;
    for (size_t i = 0; i < nodes.size() && depth < maxDepth; ++i) {
        const Node node = nodes[i];
        const uint32_t count = node.facesEnd - node.facesBegin;
        if (count > numFacesPerLeaf) {
            const uint8_t axis = node.bounds.extents().maxDimension();
            const uint32_t middle = node.facesBegin + count / 2;
            std::priority_queue<FaceAtCenter> smallest;
            uint32_t back = node.facesEnd;
            const std::vector<uint32_t> faces(faceIndices.begin() + node.facesBegin, faceIndices.begin() + node.facesEnd);
            for (uint32_t face : faces) {
                Triangle t = mesh.getTriangleFromFaceIndex(face);
                smallest.push({(t.v1[axis] + t.v2[axis] + t.v3[axis]) / 3.0f, face});
                if (smallest.size() > count / 2) {
                    faceIndices[--back] = smallest.top().face; // the largest of them goes right
                    smallest.pop();
                }
            }
            for (uint32_t k = node.facesBegin; !smallest.empty(); smallest.pop())
                faceIndices[k++] = smallest.top().face;

            if (nodes.size() < 2 * i + 3)
                nodes.resize(2 * i + 3);
            Node& left = nodes[2 * i + 1];
            Node& right = nodes[2 * i + 2];
            left = Node{AABB(), node.facesBegin, middle};
            right = Node{AABB(), middle, node.facesEnd};
            for (Node* child : {&left, &right})
                for (uint32_t face : getFaceIndices(*child)) {
                    Triangle t = mesh.getTriangleFromFaceIndex(face);
                    AABB box{t.v1, t.v1};
                    box.extend(t.v2);
                    box.extend(t.v3);
                    child->bounds.extend(box);
                }
        }
        if (--nodesLeftOnLevel == 0) {
            ++depth;
            nodesLeftOnLevel = 1u << depth;
        }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    // allocated only once; one ray at a time
    static std::vector<size_t> stack;
    static std::mutex mutex;
    const std::lock_guard<std::mutex> lock(mutex);

    Intersection nearest;
    stack.clear();
    stack.push_back(0);
    const auto& nodes = mesh.getBVH().getNodes();
    while (!stack.empty()) {
        const size_t i = stack.back();
        stack.pop_back();
        if (i >= nodes.size() || nodes[i].facesEnd == 0 || !intersect(nodes[i].bounds, ray))
            continue;
        const bool isLeaf = 2 * i + 1 >= nodes.size() || nodes[2 * i + 1].facesEnd == 0;
        if (!isLeaf) {
            stack.insert(stack.end(), {2 * i + 2, 2 * i + 1});
            continue;
        }
        for (uint32_t face : mesh.getBVH().getFaceIndices(nodes[i])) {
            Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
            if (hit.t <= nearest.t && hit)
                nearest = hit;
        }
    }
    return nearest;
}
