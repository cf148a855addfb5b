// right: a recursive quickselect (a sorting helper) of std::pair records that carry the face's AABB along, so its name speaks of boxes
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

using Item = std::pair<Point3D, std::pair<AABB, uint32_t>>; // centre, box, face

// Puts the k-th smallest centre where it belongs, smaller ones before it: items[lo..hi], all inclusive.
static void quickSelect(std::vector<Item>& items, int64_t lo, int64_t hi, int64_t k, size_t axis) {
    if (lo >= hi)
        return;
    const float a = items[lo].first[axis], b = items[lo + (hi - lo) / 2].first[axis], c = items[hi].first[axis];
    const float pivot = std::max(std::min(a, b), std::min(std::max(a, b), c));
    int64_t i = lo, j = hi;
    while (i <= j) {
        while (items[i].first[axis] < pivot) ++i;
        while (pivot < items[j].first[axis]) --j;
        if (i <= j) {
            std::swap(items[i], items[j]);
            ++i;
            --j;
        }
    }
    if (k <= j)
        quickSelect(items, lo, j, k, axis);
    else if (k >= i)
        quickSelect(items, i, hi, k, axis);
}

static AABB unite(const std::vector<Item>& items, uint32_t begin, uint32_t end) {
    AABB box;
    for (uint32_t k = begin; k < end; ++k)
        box.extend(items[k].second.first);
    return box;
}

void BVH::construct(const Mesh& mesh) {
    std::vector<Item> items;
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    items.reserve(numFaces);
    for (uint32_t face = 0; face < numFaces; ++face) {
        const Triangle t = mesh.getTriangleFromFaceIndex(face);
        AABB box;
        box.extend(t.v1);
        box.extend(t.v2);
        box.extend(t.v3);
        items.push_back({(t.v1 + t.v2 + t.v3) / 3.0f, {box, face}});
    }
    nodes.assign(1, Node{mesh.getBounds(), 0, numFaces});
    for (size_t i = 0; i < nodes.size() && std::bit_width(i + 1) <= maxDepth; ++i) {
        const Node node = nodes[i];
        if (node.facesEnd - node.facesBegin <= numFacesPerLeaf)
            continue;
        const uint32_t middle = node.facesBegin + (node.facesEnd - node.facesBegin) / 2;
        quickSelect(items, node.facesBegin, int64_t{node.facesEnd} - 1, middle, node.bounds.extents().maxDimension());
        if (nodes.size() < 2 * i + 3)
            nodes.resize(2 * i + 3);
        nodes[2 * i + 1] = {unite(items, node.facesBegin, middle), node.facesBegin, middle};
        nodes[2 * i + 2] = {unite(items, middle, node.facesEnd), middle, node.facesEnd};
    }
    faceIndices.clear();
    for (const auto& [centre, rest] : items)
        faceIndices.push_back(rest.second);
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const std::vector<BVH::Node>& nodes = mesh.getBVH().getNodes();
    Intersection closest;
    IntersectionRay rest(ray);
    std::vector<size_t> open;
    if (!nodes.empty())
        open.push_back(0);
    while (!open.empty()) {
        const size_t i = open.back();
        open.pop_back();
        if (!intersect(nodes[i].bounds, rest))
            continue;
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd != 0) {
            open.push_back(2 * i + 2);
            open.push_back(2 * i + 1);
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
