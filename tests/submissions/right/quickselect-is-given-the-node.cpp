// right: a recursive quickselect, the sorting helper, is handed the node whose faces it orders
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

struct Centres {
    std::vector<Point3D> of;
    explicit Centres(const Mesh& mesh) {
        for (const TriangleIndices& face : mesh.getFaces()) {
            const Triangle t = mesh.getTriangleFromFace(face);
            of.push_back((t.v1 + t.v2 + t.v3) / 3.0f);
        }
    }
};

// Orders faces[lo..hi) of a node along its longest side, so far that the k-th is in its place.
static void quickSelect(const BVH::Node& node, uint32_t* faces, const Centres& centres, int64_t lo, int64_t hi, int64_t k) {
    if (hi - lo < 2)
        return;
    const size_t axis = node.bounds.extents().maxDimension();
    const float pivot = centres.of[faces[lo + (hi - lo) / 2]][axis];
    int64_t i = lo, j = hi - 1;
    while (i <= j) {
        while (centres.of[faces[i]][axis] < pivot) ++i;
        while (pivot < centres.of[faces[j]][axis]) --j;
        if (i <= j)
            std::swap(faces[i++], faces[j--]);
    }
    if (k <= j)
        quickSelect(node, faces, centres, lo, j + 1, k);
    else if (k >= i)
        quickSelect(node, faces, centres, i, hi, k);
}

static AABB boxOf(const Mesh& mesh, std::span<const uint32_t> faces) {
    AABB box;
    for (const uint32_t face : faces) {
        const Triangle t = mesh.getTriangleFromFaceIndex(face);
        box.extend(t.v1);
        box.extend(t.v2);
        box.extend(t.v3);
    }
    return box;
}

void BVH::construct(const Mesh& mesh) {
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    const Centres centres(mesh);
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.assign(1, Node{mesh.getBounds(), 0, numFaces});
    std::queue<std::pair<size_t, uint32_t>> todo;
    todo.push({0, 0});
    while (!todo.empty()) {
        const auto [i, depth] = todo.front();
        todo.pop();
        const Node node = nodes[i];
        const uint32_t count = node.facesEnd - node.facesBegin;
        if (count <= numFacesPerLeaf || depth >= maxDepth)
            continue;
        const uint32_t middle = node.facesBegin + count / 2;
        quickSelect(node, faceIndices.data(), centres, node.facesBegin, node.facesEnd, middle);
        const std::span<const uint32_t> all(faceIndices);
        if (nodes.size() < 2 * i + 3)
            nodes.resize(2 * i + 3);
        nodes[2 * i + 1] = {boxOf(mesh, all.subspan(node.facesBegin, middle - node.facesBegin)), node.facesBegin, middle};
        nodes[2 * i + 2] = {boxOf(mesh, all.subspan(middle, node.facesEnd - middle)), middle, node.facesEnd};
        todo.push({2 * i + 1, depth + 1});
        todo.push({2 * i + 2, depth + 1});
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const auto& nodes = mesh.getBVH().getNodes();
    Intersection best;
    IntersectionRay rest = ray;
    std::stack<size_t> open;
    if (!nodes.empty())
        open.push(0);
    while (!open.empty()) {
        const size_t i = open.top();
        open.pop();
        if (!intersect(nodes[i].bounds, rest))
            continue;
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd > 0) {
            open.push(2 * i + 1);
            open.push(2 * i + 2);
            continue;
        }
        for (const uint32_t face : mesh.getBVH().getFaceIndices(nodes[i]))
            if (const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), rest)) {
                best = hit;
                rest.t_max = hit.t;
            }
    }
    return best;
}
