// right: two threads run a member function; what it throws is caught there, printed by the virtual what() and thrown again later
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

class TreeBuilder {
  public:
    TreeBuilder(const Mesh& mesh, std::vector<BVH::Node>& nodes, std::vector<uint32_t>& faces)
        : mesh(mesh), nodes(nodes), faces(faces) {}

    // Splits the nodes first, ... last - 1, which are those of one level, in two threads.
    void splitLevel(size_t first, size_t last) {
        next = first;
        end = last;
        std::vector<std::thread> threads;
        for (int k = 0; k < 2; ++k)
            threads.emplace_back(&TreeBuilder::work, this);
        for (std::thread& thread : threads)
            thread.join();
        if (failure)
            std::rethrow_exception(failure);
    }

  private:
    void work() {
        try {
            for (size_t i = next++; i < end; i = next++)
                split(i);
        } catch (const std::exception& e) {
            const std::lock_guard lock(mutex);
            std::cerr << "construct: " << e.what() << std::endl;
            failure = std::current_exception();
        }
    }

    Point3D triangleCenter(uint32_t face) const {
        const Triangle t = mesh.getTriangleFromFaceIndex(face);
        return (t.v1 + t.v2 + t.v3) / 3.0f;
    }

    AABB boundsOf(uint32_t from, uint32_t to) const {
        AABB box;
        for (uint32_t k = from; k < to; ++k) {
            const Triangle t = mesh.getTriangleFromFaceIndex(faces.at(k));
            box.extend(t.v1);
            box.extend(t.v2);
            box.extend(t.v3);
        }
        return box;
    }

    void split(size_t i) {
        const BVH::Node node = nodes.at(i);
        const uint32_t count = node.facesEnd - node.facesBegin;
        if (count <= BVH::numFacesPerLeaf)
            return;
        const uint8_t axis = node.bounds.extents().maxDimension();
        const uint32_t middle = node.facesBegin + count / 2;
        std::nth_element(faces.begin() + node.facesBegin, faces.begin() + middle, faces.begin() + node.facesEnd,
                         [&](uint32_t a, uint32_t b) { return triangleCenter(a)[axis] < triangleCenter(b)[axis]; });
        nodes.at(2 * i + 1) = {boundsOf(node.facesBegin, middle), node.facesBegin, middle};
        nodes.at(2 * i + 2) = {boundsOf(middle, node.facesEnd), middle, node.facesEnd};
    }

    const Mesh& mesh;
    std::vector<BVH::Node>& nodes;
    std::vector<uint32_t>& faces;
    std::atomic<size_t> next{0};
    size_t end{0};
    std::mutex mutex;
    std::exception_ptr failure;
};

void BVH::construct(const Mesh& mesh) {
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);

    uint32_t levels = 0;
    for (uint32_t largest = numFaces; largest > numFacesPerLeaf && levels < maxDepth; largest -= largest / 2)
        ++levels;
    nodes.assign((size_t{2} << levels) - 1, Node{});
    nodes[0] = {mesh.getBounds(), 0, numFaces};

    TreeBuilder builder(mesh, nodes, faceIndices);
    for (uint32_t level = 0; level < levels; ++level)
        builder.splitLevel((size_t{1} << level) - 1, (size_t{2} << level) - 1);
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const std::vector<BVH::Node>& nodes = mesh.getBVH().getNodes();
    Intersection closest;
    IntersectionRay rest{ray};
    std::vector<size_t> stack;
    if (!nodes.empty())
        stack.push_back(0);
    while (!stack.empty()) {
        const size_t i = stack.back();
        stack.pop_back();
        if (!intersect(nodes[i].bounds, rest))
            continue;
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd != 0) {
            stack.push_back(2 * i + 2);
            stack.push_back(2 * i + 1);
            continue;
        }
        for (const uint32_t face : mesh.getBVH().getFaceIndices(nodes[i])) {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), rest);
            if (hit) {
                closest = hit;
                rest.t_max = hit.t;
            }
        }
    }
    return closest;
}
