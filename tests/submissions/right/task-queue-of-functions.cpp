// right: a work queue of std::function<void()>: the task of a node enqueues those of its children, and a loop runs them in turn
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <deque>
#include <functional>
#include <memory>
#include <optional>

using Task = std::function<void()>;

class Scheduler {
  public:
    void post(Task task) { tasks.push_back(std::move(task)); }
    std::optional<Task> next() {
        if (tasks.empty())
            return std::nullopt;
        Task task = std::move(tasks.front());
        tasks.pop_front();
        return task;
    }

  private:
    std::deque<Task> tasks;
};

struct Builder {
    const Mesh& mesh;
    std::vector<BVH::Node>& nodes;
    std::vector<uint32_t>& order;
    Scheduler& scheduler;
    std::function<float(uint32_t, uint8_t)> center;

    AABB enclose(uint32_t begin, uint32_t end) const {
        return std::accumulate(order.begin() + begin, order.begin() + end, AABB{}, [this](AABB box, uint32_t face) {
            const Triangle t = mesh.getTriangleFromFaceIndex(face);
            for (const Point3D* p : {&t.v1, &t.v2, &t.v3})
                box.extend(*p);
            return box;
        });
    }

    void enqueue(size_t index, uint32_t depth) {
        scheduler.post([this, index, depth] { split(index, depth); });
    }

    void split(size_t index, uint32_t depth) {
        const BVH::Node node = nodes.at(index);
        if (depth >= BVH::maxDepth || node.facesEnd - node.facesBegin <= BVH::numFacesPerLeaf)
            return;
        const uint8_t axis = node.bounds.extents().maxDimension();
        const uint32_t mid = std::midpoint(node.facesBegin, node.facesEnd);
        std::nth_element(order.begin() + node.facesBegin, order.begin() + mid, order.begin() + node.facesEnd,
                         [&](uint32_t a, uint32_t b) { return center(a, axis) < center(b, axis); });
        if (nodes.size() < 2 * index + 3)
            nodes.resize(2 * index + 3);
        nodes[2 * index + 1] = {enclose(node.facesBegin, mid), node.facesBegin, mid};
        nodes[2 * index + 2] = {enclose(mid, node.facesEnd), mid, node.facesEnd};
        enqueue(2 * index + 1, depth + 1);
        enqueue(2 * index + 2, depth + 1);
    }
};

void BVH::construct(const Mesh& mesh) {
    const auto count = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.assign(count, 0);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.assign(1, Node{mesh.getBounds(), 0, count});
    Scheduler scheduler;
    Builder builder{mesh, nodes, faceIndices, scheduler, [&mesh](uint32_t face, uint8_t axis) {
        const auto [a, b, c] = mesh.getFaces()[face];
        const auto& v = mesh.getVertices();
        return v[a][axis] / 3 + v[b][axis] / 3 + v[c][axis] / 3;
    }};
    builder.enqueue(0, 0);
    while (auto task = scheduler.next())
        (*task)();
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    Scheduler scheduler;
    Intersection best;
    const auto& nodes = mesh.getBVH().getNodes();
    std::function<void(size_t)> visit = [&](size_t i) {
        if (!intersect(nodes[i].bounds, ray))
            return;
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd) {
            scheduler.post(std::bind(visit, 2 * i + 1));
            scheduler.post(std::bind_front(visit, 2 * i + 2));
            return;
        }
        for (auto face : mesh.getBVH().getFaceIndices(nodes[i]))
            if (auto hit = intersect(mesh.getTriangleFromFaceIndex(face), ray); hit.t < best.t)
                best = hit;
    };
    if (!nodes.empty())
        scheduler.post([&] { visit(0); });
    while (auto task = scheduler.next())
        task.value()();
    return best;
}
