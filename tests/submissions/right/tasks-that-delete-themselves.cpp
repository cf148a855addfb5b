// right: a queue of tasks with a virtual run(), which splits a node, posts two new tasks and deletes its own
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <deque>

class Task {
  public:
    virtual ~Task() = default;
    virtual void run() = 0; // deletes the task in the end
};

class TaskQueue {
  public:
    void post(Task* task) { waiting.push_back(task); }
    void runAll() {
        while (!waiting.empty()) {
            Task* const task = waiting.front();
            waiting.pop_front();
            task->run();
        }
    }

  private:
    std::deque<Task*> waiting;
};

struct Workshop {
    const Mesh& mesh;
    std::vector<BVH::Node>& nodes;
    std::vector<uint32_t>& faces;
    std::vector<Point3D> centers;
    TaskQueue queue;
};

class SplitTask : public Task {
  public:
    SplitTask(Workshop& shop, size_t node, uint32_t depth) : shop(shop), index(node), depth(depth) {}

    void run() override {
        const BVH::Node node = shop.nodes[index];
        const uint32_t count = node.facesEnd - node.facesBegin;
        if (count > BVH::numFacesPerLeaf && depth < BVH::maxDepth) {
            const uint32_t middle = node.facesBegin + (count + 1) / 2;
            const uint8_t axis = node.bounds.extents().maxDimension();
            uint32_t* const f = shop.faces.data();
            std::nth_element(f + node.facesBegin, f + middle, f + node.facesEnd, [&](uint32_t a, uint32_t b) {
                return shop.centers[a][axis] < shop.centers[b][axis];
            });
            if (shop.nodes.size() < 2 * index + 3)
                shop.nodes.resize(2 * index + 3);
            shop.nodes[2 * index + 1] = {boundsOf(node.facesBegin, middle), node.facesBegin, middle};
            shop.nodes[2 * index + 2] = {boundsOf(middle, node.facesEnd), middle, node.facesEnd};
            shop.queue.post(new SplitTask(shop, 2 * index + 1, depth + 1));
            shop.queue.post(new SplitTask(shop, 2 * index + 2, depth + 1));
        }
        delete this;
    }

  private:
    AABB boundsOf(uint32_t begin, uint32_t end) const {
        AABB box;
        for (uint32_t k = begin; k < end; ++k) {
            const Triangle t = shop.mesh.getTriangleFromFaceIndex(shop.faces[k]);
            box.extend(t.v1);
            box.extend(t.v2);
            box.extend(t.v3);
        }
        return box;
    }

    Workshop& shop;
    size_t index;
    uint32_t depth;
};

void BVH::construct(const Mesh& mesh) {
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.assign(1, Node{mesh.getBounds(), 0, numFaces});

    Workshop shop{mesh, nodes, faceIndices, {}, {}};
    shop.centers.reserve(numFaces);
    for (uint32_t face = 0; face < numFaces; ++face) {
        const Triangle t = mesh.getTriangleFromFaceIndex(face);
        shop.centers.push_back((t.v1 + t.v2 + t.v3) / 3.0f);
    }
    shop.queue.post(new SplitTask(shop, 0, 0));
    shop.queue.runAll();
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const auto& nodes = mesh.getBVH().getNodes();
    Intersection closest;
    IntersectionRay rest{ray};
    std::stack<size_t> open;
    if (!nodes.empty())
        open.push(0);
    while (!open.empty()) {
        const size_t i = open.top();
        open.pop();
        if (!intersect(nodes[i].bounds, rest))
            continue;
        const size_t left = 2 * i + 1;
        if (left + 1 < nodes.size() && nodes[left].facesEnd != 0) {
            open.push(left + 1);
            open.push(left);
            continue;
        }
        for (const uint32_t face : mesh.getBVH().getFaceIndices(nodes[i])) {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), rest);
            if (hit.t < closest.t) {
                closest = hit;
                rest.t_max = hit.t;
            }
        }
    }
    return closest;
}
