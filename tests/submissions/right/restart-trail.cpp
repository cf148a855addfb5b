// right: intersect has no stack: a bit per level says which half is done, and the walk starts at the root again after every leaf (restart trail, Laine 2010), near child first
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

namespace {

std::vector<Point3D> centresOf(const Mesh& mesh) {
    std::vector<Point3D> centres;
    centres.reserve(mesh.getFaces().size());
    for (const TriangleIndices& face : mesh.getFaces()) {
        const Triangle t = mesh.getTriangleFromFace(face);
        centres.push_back((t.v1 + t.v2 + t.v3) / 3.0f);
    }
    return centres;
}

AABB boxOf(const Mesh& mesh, std::span<const uint32_t> faces) {
    AABB box;
    for (const uint32_t face : faces) {
        const Triangle t = mesh.getTriangleFromFaceIndex(face);
        box.extend(t.v1);
        box.extend(t.v2);
        box.extend(t.v3);
    }
    return box;
}

} // namespace

void BVH::construct(const Mesh& mesh) {
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.assign(1, Node{mesh.getBounds(), 0, numFaces});
    const std::vector<Point3D> centres = centresOf(mesh);
    for (size_t i = 0; i < nodes.size() && std::bit_width(i + 1) <= maxDepth; ++i) {
        const Node node = nodes[i];
        if (node.facesEnd - node.facesBegin <= numFacesPerLeaf)
            continue;
        const uint32_t middle = node.facesBegin + (node.facesEnd - node.facesBegin) / 2;
        const size_t axis = node.bounds.extents().maxDimension();
        std::nth_element(faceIndices.begin() + node.facesBegin, faceIndices.begin() + middle, faceIndices.begin() + node.facesEnd,
                         [&](uint32_t a, uint32_t b) { return centres[a][axis] < centres[b][axis]; });
        if (nodes.size() < 2 * i + 3)
            nodes.resize(2 * i + 3);
        const std::span<const uint32_t> all(faceIndices);
        nodes[2 * i + 1] = {boxOf(mesh, all.subspan(node.facesBegin, middle - node.facesBegin)), node.facesBegin, middle};
        nodes[2 * i + 2] = {boxOf(mesh, all.subspan(middle, node.facesEnd - middle)), middle, node.facesEnd};
    }
}

static bool isLeaf(const std::vector<BVH::Node>& nodes, size_t i) {
    return 2 * i + 2 >= nodes.size() || nodes[2 * i + 1].facesEnd == 0;
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const auto& nodes = mesh.getBVH().getNodes();
    Intersection closest;
    IntersectionRay rest(ray);
    if (nodes.empty())
        return closest;
    // Bit (63 - level) of the trail: the first choice below the node on this level of the path is done.
    uint64_t trail = 0;
    for (;;) {
        size_t i = 0;
        uint32_t level = 0;
        bool entered = intersect(nodes[0].bounds, rest);
        // Down to a leaf, or to a box that is missed.
        while (entered && !isLeaf(nodes, i)) {
            const Vector3D across = nodes[2 * i + 2].bounds.center() - nodes[2 * i + 1].bounds.center();
            const size_t first = dot(ray.direction, across) >= 0 ? 1 : 2; // does not depend on what was hit
            const bool second = trail >> (63 - level) & 1;
            i = 2 * i + (second ? 3 - first : first);
            ++level;
            entered = intersect(nodes[i].bounds, rest);
        }
        if (entered) {
            for (const uint32_t face : mesh.getBVH().getFaceIndices(nodes[i])) {
                if (const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), rest)) {
                    closest = hit;
                    rest.t_max = hit.t;
                }
            }
        }
        // Count up at the last level of this path, and forget what is below; a carry goes to parents.
        if (level == 0)
            return closest;
        const uint64_t unit = uint64_t{1} << (64 - level);
        const uint64_t before = trail & ~(unit - 1);
        trail = before + unit;
        if (trail < before || trail == 0) // the carry left the root: both halves are done
            return closest;
    }
}
