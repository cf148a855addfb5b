// right: intersect treats the binary tree as one of sixteen children a node: only every fourth level of boxes is tested
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

/// The used descendants of node `i`, `levels` further down, and leaves above them.
static uint32_t gather(const std::vector<BVH::Node>& nodes, uint32_t i, uint32_t levels, uint32_t* out) {
    uint32_t count = 1;
    out[0] = i;
    for (uint32_t level = 0; level < levels; ++level) {
        uint32_t next[64], more = 0;
        for (uint32_t k = 0; k < count; ++k) {
            if (isLeaf(nodes, out[k])) {
                next[more++] = out[k];
            } else {
                next[more++] = 2 * out[k] + 1;
                next[more++] = 2 * out[k] + 2;
            }
        }
        std::copy(next, next + more, out);
        count = more;
    }
    return count;
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const auto& nodes = mesh.getBVH().getNodes();
    Intersection closest;
    IntersectionRay rest(ray);
    std::vector<uint32_t> open;
    uint32_t wide[64];
    if (nodes.empty() || !intersect(nodes[0].bounds, rest))
        return closest;
    const uint32_t few = gather(nodes, 0, 4, wide);
    for (uint32_t k = few; k-- > 0;)
        if (intersect(nodes[wide[k]].bounds, rest))
            open.push_back(wide[k]);
    while (!open.empty()) {
        const uint32_t i = open.back();
        open.pop_back();
        if (isLeaf(nodes, i)) {
            for (const uint32_t face : mesh.getBVH().getFaceIndices(nodes[i])) {
                if (const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), rest)) {
                    closest = hit;
                    rest.t_max = hit.t;
                }
            }
            continue;
        }
        const uint32_t count = gather(nodes, i, 4, wide);
        for (uint32_t k = count; k-- > 0;)
            if (intersect(nodes[wide[k]].bounds, rest))
                open.push_back(wide[k]);
    }
    return closest;
}
