// right: a pool of std::jthread with a shared stack of jobs builds the tree; intersect walks it with three states and no stack (Hapala)
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <condition_variable>
#include <exception>
#include <latch>
#include <mutex>
#include <thread>

namespace pool {

struct Job {
    uint32_t index;
    uint32_t depth;
};

class Jobs {
    std::mutex mutex;
    std::condition_variable changed;
    std::vector<Job> waiting;
    size_t unfinished = 0;
    std::exception_ptr error;

  public:
    void add(std::initializer_list<Job> jobs) {
        {
            const std::scoped_lock lock(mutex);
            waiting.insert(waiting.end(), jobs);
            unfinished += jobs.size();
        }
        changed.notify_all();
    }
    bool take(Job& job) {
        std::unique_lock lock(mutex);
        changed.wait(lock, [this] { return !waiting.empty() || unfinished == 0; });
        if (waiting.empty())
            return false;
        job = waiting.back();
        waiting.pop_back();
        return true;
    }
    void done(std::exception_ptr problem = nullptr) {
        const std::scoped_lock lock(mutex);
        if (problem && !error)
            error = problem;
        if (--unfinished == 0)
            changed.notify_all();
    }
    void rethrow() const {
        if (error)
            std::rethrow_exception(error);
    }
};

} // namespace pool

void BVH::construct(const Mesh& mesh) {
    const uint32_t n = static_cast<uint32_t>(mesh.getFaces().size());
    *this = {};
    faceIndices.resize(n);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    // how many levels there will be follows from the number of faces: the larger half decides
    uint32_t levels = 0;
    for (uint32_t most = n; most > numFacesPerLeaf && levels < maxDepth; most = most - most / 2)
        ++levels;
    nodes.resize((size_t(2) << levels) - 1);
    nodes[0] = Node{mesh.getBounds(), 0, n};

    pool::Jobs jobs;
    const auto split = [&](const pool::Job& job) {
        const Node node = nodes[job.index];
        const uint32_t count = node.facesEnd - node.facesBegin;
        if (count <= numFacesPerLeaf || job.depth == maxDepth)
            return;
        const auto axis = node.bounds.extents().maxDimension();
        std::vector<std::pair<float, uint32_t>> sorted;
        sorted.reserve(count);
        for (uint32_t f : getFaceIndices(node)) {
            const Triangle t = mesh.getTriangleFromFaceIndex(f);
            sorted.emplace_back(((t.v1 + t.v2 + t.v3) / 3.0f)[axis], f);
        }
        std::nth_element(sorted.begin(), sorted.begin() + count / 2, sorted.end());
        std::transform(sorted.begin(), sorted.end(), getFaceIndices(node).begin(), [](const auto& entry) { return entry.second; });
        const uint32_t middle = node.facesBegin + count / 2;
        for (uint32_t k = node.facesBegin; k < node.facesEnd; ++k) {
            const Triangle t = mesh.getTriangleFromFaceIndex(faceIndices[k]);
            AABB& box = nodes.at(2 * job.index + (k < middle ? 1 : 2)).bounds;
            box.extend(t.v1);
            box.extend(t.v2);
            box.extend(t.v3);
        }
        for (const auto& [child, begin, end] : {std::array{2 * job.index + 1, node.facesBegin, middle}, std::array{2 * job.index + 2, middle, node.facesEnd}}) {
            nodes[child].facesBegin = begin;
            nodes[child].facesEnd = end;
        }
        jobs.add({{2 * job.index + 1, job.depth + 1}, {2 * job.index + 2, job.depth + 1}});
    };

    jobs.add({{0, 0}});
    constexpr int numThreads = 4;
    std::latch started(numThreads);
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < numThreads; ++i)
            threads.emplace_back([&] {
                started.arrive_and_wait();
                for (pool::Job job; jobs.take(job);) {
                    try {
                        split(job);
                        jobs.done();
                    } catch (...) {
                        jobs.done(std::current_exception());
                    }
                }
            });
    }
    jobs.rethrow();
}

// Moves through the tree without a stack: three states, as in Hapala et al.
Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    enum class From { Parent, Sibling, Child };
    const auto& nodes = mesh.getBVH().getNodes();
    Intersection best;
    if (nodes.empty())
        return best;
    const auto isLeaf = [&](size_t i) { return 2 * i + 2 >= nodes.size() || nodes[2 * i + 1].facesEnd == 0; };
    const auto tryLeaf = [&](size_t i) {
        for (uint32_t f : mesh.getBVH().getFaceIndices(nodes[i])) {
            Intersection hit = intersect(mesh.getTriangleFromFaceIndex(f), ray);
            if (hit.t < best.t)
                best = std::move(hit);
        }
    };
    const auto nearFirst = [&](size_t parent) -> size_t {
        const auto axis = nodes[parent].bounds.extents().maxDimension();
        return 2 * parent + (ray.direction[axis] < 0 ? 2 : 1);
    };
    const auto sibling = [](size_t i) { return i % 2 ? i + 1 : i - 1; };
    if (!intersect(nodes[0].bounds, ray))
        return best;
    if (isLeaf(0)) {
        tryLeaf(0);
        return best;
    }
    size_t at = nearFirst(0);
    From from = From::Parent;
    while (true) {
        switch (from) {
        case From::Child:
            if (at == 0)
                return best;
            if (at == nearFirst((at - 1) / 2)) {
                at = sibling(at);
                from = From::Sibling;
            } else
                at = (at - 1) / 2;
            break;
        case From::Sibling:
        case From::Parent:
            const bool met = intersect(nodes[at].bounds, ray);
            if (met && !isLeaf(at)) {
                at = nearFirst(at);
                from = From::Parent;
                break;
            }
            if (met)
                tryLeaf(at);
            if (from == From::Parent) {
                at = sibling(at);
                from = From::Sibling;
            } else {
                at = (at - 1) / 2;
                from = From::Child;
            }
            break;
        }
    }
}
