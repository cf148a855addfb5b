// right: the nodes of a level are split in parallel by std::async and an atomic counter; intersect counts its rays in a static atomic
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <atomic>
#include <future>
#include <thread>

static std::atomic<unsigned long long> numRays{0}; // for the statistics below

void BVH::construct(const Mesh& mesh)
{
    const uint32_t numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    nodes.clear();
    nodes.push_back(Node{mesh.getBounds(), 0, numFaces});
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);

    const unsigned numThreads = std::clamp(std::thread::hardware_concurrency(), 1u, 8u);
    for (uint32_t depth = 0; depth < maxDepth; ++depth) {
        // all nodes of one level are independent of each other
        const uint32_t first = (1u << depth) - 1;
        if (first >= nodes.size())
            break;
        std::vector<uint32_t> level;
        for (uint32_t i = first; i <= 2 * first && i < nodes.size(); ++i)
            if (nodes[i].facesEnd - nodes[i].facesBegin > numFacesPerLeaf)
                level.push_back(i);
        if (level.empty())
            break;
        nodes.resize(2 * level.back() + 3); // before the threads start: nobody moves the nodes then

        std::atomic<size_t> next{0};
        const auto work = [&] {
            for (size_t k; (k = next.fetch_add(1)) < level.size();) {
                const uint32_t i = level[k];
                const Node& node = nodes[i];
                const uint8_t axis = node.bounds.extents().maxDimension();
                const uint32_t middle = node.facesBegin + (node.facesEnd - node.facesBegin) / 2;
                const auto center = [&](uint32_t face) {
                    const Triangle t = mesh.getTriangleFromFaceIndex(face);
                    return (t.v1[axis] + t.v2[axis] + t.v3[axis]) / 3.f;
                };
                std::nth_element(faceIndices.begin() + node.facesBegin, faceIndices.begin() + middle, faceIndices.begin() + node.facesEnd,
                                 [&](uint32_t a, uint32_t b) { return center(a) < center(b); });
                const auto fill = [&](Node& child, uint32_t begin, uint32_t end) {
                    child.facesBegin = begin;
                    child.facesEnd = end;
                    for (uint32_t k = begin; k < end; ++k) {
                        const Triangle t = mesh.getTriangleFromFaceIndex(faceIndices[k]);
                        child.bounds.extend(t.v1);
                        child.bounds.extend(t.v2);
                        child.bounds.extend(t.v3);
                    }
                };
                fill(nodes[2 * i + 1], node.facesBegin, middle);
                fill(nodes[2 * i + 2], middle, node.facesEnd);
            }
        };
        std::vector<std::future<void>> helpers;
        if (numFaces > 1000)
            for (unsigned t = 1; t < numThreads; ++t)
                helpers.push_back(std::async(std::launch::async, work));
        work();
        for (auto& helper : helpers)
            helper.get();
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    numRays.fetch_add(1, std::memory_order_relaxed);

    Intersection best;
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    Ray rest = ray; // is cut off at the closest hit
    std::vector<uint32_t> stack;
    stack.reserve(32);
    if (bvh.isConstructed())
        stack.push_back(0);
    while (!stack.empty()) {
        const uint32_t i = stack.back();
        stack.pop_back();
        const IntersectionRay current(rest);
        if (!intersect(nodes[i].bounds, current))
            continue;
        const size_t left = 2 * size_t(i) + 1;
        if (left < nodes.size() && nodes[left].facesEnd > 0) {
            stack.push_back(left);
            stack.push_back(left + 1);
            continue;
        }
        for (uint32_t face : bvh.getFaceIndices(nodes[i]))
            if (const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), IntersectionRay(rest))) {
                best = hit;
                rest.t_max = hit.t;
            }
    }
    return best;
}
