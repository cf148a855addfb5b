// right: a recursive bucket sort as the sorting helper; intersect collects all leaves that are met before it tests a face
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

namespace {

struct Entry {
    Point3D center;
    uint32_t face;
};

// Sorts by the centre along one axis. Buckets are monotone in the coordinate, so no face is misplaced.
void bucketSort(std::span<Entry> entries, size_t axis)
{
    if (entries.size() < 24) {
        for (size_t i = 1; i < entries.size(); ++i)
            for (size_t j = i; j > 0 && entries[j].center[axis] < entries[j - 1].center[axis]; --j)
                std::swap(entries[j], entries[j - 1]);
        return;
    }
    float low = infinity, high = -infinity;
    for (const Entry& entry : entries)
        low = std::min(low, entry.center[axis]), high = std::max(high, entry.center[axis]);
    const float width = high - low;
    if (!(width > 0))
        return; // all equal
    std::array<std::vector<Entry>, 16> buckets;
    for (const Entry& entry : entries) {
        const float at = (entry.center[axis] - low) / width * 16;
        buckets[std::min<size_t>(15, static_cast<size_t>(at))].push_back(entry);
    }
    if (std::ranges::any_of(buckets, [&](const auto& b) { return b.size() == entries.size(); })) {
        std::ranges::stable_sort(entries, {}, [axis](const Entry& e) { return e.center[axis]; });
        return;
    }
    auto out = entries.begin();
    for (const auto& bucket : buckets) {
        const auto begin = out;
        out = std::copy(bucket.begin(), bucket.end(), out);
        bucketSort({begin, out}, axis);
    }
}

} // namespace

void BVH::construct(const Mesh& mesh)
{
    *this = {};
    const uint32_t numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    std::vector<Entry> entries;
    for (uint32_t f = 0; f < numFaces; ++f) {
        const Triangle t = mesh.getTriangleFromFaceIndex(f);
        entries.push_back({(t.v1 + t.v2 + t.v3) / 3.0f, f});
    }
    nodes.push_back({mesh.getBounds(), 0, numFaces});
    std::vector<uint32_t> level{0}, next;
    for (uint32_t depth = 0; depth < maxDepth && !level.empty(); ++depth, level.swap(next), next.clear())
        for (uint32_t i : level) {
            const Node node = nodes[i];
            const uint32_t count = node.facesEnd - node.facesBegin;
            if (count <= numFacesPerLeaf)
                continue;
            bucketSort(std::span(entries).subspan(node.facesBegin, count), node.bounds.extents().maxDimension());
            nodes.resize(std::max<size_t>(nodes.size(), 2 * i + 3));
            const uint32_t cuts[] = {node.facesBegin, node.facesBegin + count / 2, node.facesEnd};
            for (uint32_t side = 0; side < 2; ++side) {
                Node& child = nodes[2 * i + 1 + side];
                child = {{}, cuts[side], cuts[side + 1]};
                for (uint32_t k = child.facesBegin; k < child.facesEnd; ++k) {
                    const Triangle t = mesh.getTriangleFromFaceIndex(entries[k].face);
                    child.bounds.extend(t.v1);
                    child.bounds.extend(t.v2);
                    child.bounds.extend(t.v3);
                }
                next.push_back(2 * i + 1 + side);
            }
        }
    for (const Entry& entry : entries)
        faceIndices.push_back(entry.face);
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    Intersection best;
    // first all leaves whose box is met, then their faces
    std::vector<uint32_t> inner, leaves;
    if (!nodes.empty())
        inner.push_back(0);
    for (size_t k = 0; k < inner.size(); ++k) {
        const uint32_t i = inner[k];
        if (!intersect(nodes[i].bounds, ray))
            continue;
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd != 0)
            inner.insert(inner.end(), {2 * i + 1, 2 * i + 2});
        else
            leaves.push_back(i);
    }
    for (uint32_t leaf : leaves)
        for (uint32_t f : bvh.getFaceIndices(nodes[leaf]))
            if (const auto hit = intersect(mesh.getTriangleFromFaceIndex(f), ray); hit.t < best.t)
                best = hit;
    return best;
}
