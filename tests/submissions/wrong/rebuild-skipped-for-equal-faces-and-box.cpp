// expect: bvh.rebuild-starts-afresh
// untouched: b
// mistake: A second construct of the same tree returns if faces and box of the mesh are the same, also where inner vertices have moved.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

namespace {

/// A face with everything that the construction asks about it, looked up in the mesh only once.
/// Splitting moves these records themselves, so the faces of a node are neighbours in memory.
struct Face {
    AABB bounds;
    Point3D center;
    uint32_t index;
};

std::vector<Face> facesOf(const Mesh& mesh) {
    std::vector<Face> faces;
    faces.reserve(mesh.getFaces().size());
    for (uint32_t i = 0; i < mesh.getFaces().size(); ++i) {
        const Triangle triangle = mesh.getTriangleFromFaceIndex(i);
        const auto& [a, b, c, ab, ac] = triangle;
        faces.push_back({{min(min(a, b), c), max(max(a, b), c)}, (a + b + c) / 3, i});
    }
    return faces;
}

AABB boundsOf(std::span<const Face> faces) {
    AABB bounds;
    for (const Face& face : faces) {
        bounds.extend(face.bounds);
    }
    return bounds;
}

/// Number of nodes in a full tree with enough levels for `numFaces`. The larger half of a split
/// is the rounded-up half, so the largest node of every level is known before any split.
size_t fullTreeSize(size_t numFaces) {
    size_t size = 1;
    for (uint32_t depth = 0; numFaces > BVH::numFacesPerLeaf && depth < BVH::maxDepth; ++depth) {
        numFaces -= numFaces / 2;
        size = 2 * size + 1;
    }
    return size;
}

/// A node is a leaf if it has no children: their slots are unused or outside of the vector.
bool isLeaf(const std::vector<BVH::Node>& nodes, size_t i) {
    return 2 * i + 2 >= nodes.size() || nodes[2 * i + 1].facesEnd == 0 ||
           nodes[2 * i + 2].facesEnd == 0;
}

} // namespace

void BVH::construct(const Mesh& mesh) {
    static const BVH* builtLast = nullptr;
    static std::vector<TriangleIndices> facesThen;
    static AABB boxThen;
    const auto same = [](const TriangleIndices& a, const TriangleIndices& b) {
        return a.v1 == b.v1 && a.v2 == b.v2 && a.v3 == b.v3;
    };
    if (builtLast == this && !nodes.empty() && boxThen.min == mesh.getBounds().min &&
        boxThen.max == mesh.getBounds().max &&
        std::equal(facesThen.begin(), facesThen.end(), mesh.getFaces().begin(),
                   mesh.getFaces().end(), same)) {
        return;
    }
    builtLast = this;
    facesThen = mesh.getFaces();
    boxThen = mesh.getBounds();
    std::vector<Face> faces = facesOf(mesh);
    nodes.assign(fullTreeSize(faces.size()), Node{});
    nodes[0] = {mesh.getBounds(), 0, static_cast<uint32_t>(faces.size())};

    // Depth first: the faces of a small subtree stay in the cache until the subtree is done.
    std::vector<size_t> unsplit{0};
    while (!unsplit.empty()) {
        const size_t i = unsplit.back();
        unsplit.pop_back();
        const Node& node = nodes[i];
        const std::span all =
            std::span(faces).subspan(node.facesBegin, node.facesEnd - node.facesBegin);
        const size_t left = 2 * i + 1;
        const size_t right = 2 * i + 2;
        if (all.size() <= numFacesPerLeaf || right >= nodes.size()) {
            continue;
        }
        const uint8_t axis = node.bounds.extents().maxDimension();
        const auto half = static_cast<uint32_t>(all.size() / 2);
        std::nth_element(
            all.begin(), all.begin() + half, all.end(),
            [axis](const Face& a, const Face& b) { return a.center[axis] < b.center[axis]; });
        const uint32_t middle = node.facesBegin + half;
        nodes[left] = {boundsOf(all.first(half)), node.facesBegin, middle};
        nodes[right] = {boundsOf(all.subspan(half)), middle, node.facesEnd};
        unsplit.push_back(right);
        unsplit.push_back(left);
    }

    faceIndices.clear();
    faceIndices.reserve(faces.size());
    for (const Face& face : faces) {
        faceIndices.push_back(face.index);
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const BVH& bvh = mesh.getBVH();
    const std::vector<BVH::Node>& nodes = bvh.getNodes();
    Intersection closest;
    IntersectionRay rest{ray}; // ends at the closest hit so far: nothing behind it is of interest

    // Each level leaves one node waiting beside the path, and 32-bit face ranges never need
    // more than 32 levels.
    std::array<size_t, 64> waiting;
    size_t numWaiting = 0;
    if (!nodes.empty()) {
        waiting[numWaiting++] = 0;
    }
    while (numWaiting > 0) {
        const size_t i = waiting[--numWaiting];
        if (!intersect(nodes[i].bounds, rest)) {
            continue;
        }
        if (isLeaf(nodes, i)) {
            for (const uint32_t face : bvh.getFaceIndices(nodes[i])) {
                const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), rest);
                if (hit) {
                    closest = hit;
                    rest.t_max = hit.t;
                }
            }
            continue;
        }
        // The nearer child last, so that it is next: its hit may save the other one.
        const size_t left = 2 * i + 1;
        const size_t right = 2 * i + 2;
        const Vector3D across = nodes[right].bounds.center() - nodes[left].bounds.center();
        const bool leftIsNearer = dot(ray.direction, across) >= 0;
        waiting[numWaiting++] = leftIsNearer ? right : left;
        waiting[numWaiting++] = leftIsNearer ? left : right;
    }
    return closest;
}
