// right: a recursive quickselect as the sorting helper whose comparator asks the node's box for its longest axis at every comparison
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

struct AlongTheLongestAxis {
    const std::vector<Point3D>& centres;
    const AABB& box;
    bool operator()(uint32_t a, uint32_t b) const {
        const size_t axis = box.extents().maxDimension();
        return centres[a][axis] < centres[b][axis];
    }
};

template <typename Less> static void quickSelect(std::span<uint32_t> faces, size_t k, const Less& less) {
    if (faces.size() < 2)
        return;
    std::ptrdiff_t i = 0, j = std::ssize(faces) - 1;
    const uint32_t pivot = faces[faces.size() / 2];
    while (i <= j) {
        while (less(faces[i], pivot)) ++i;
        while (less(pivot, faces[j])) --j;
        if (i <= j)
            std::swap(faces[i++], faces[j--]);
    }
    if (std::ptrdiff_t(k) <= j)
        quickSelect(faces.first(j + 1), k, less);
    else if (std::ptrdiff_t(k) >= i)
        quickSelect(faces.subspan(i), k - i, less);
}

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
        quickSelect(getFaceIndices(node), middle - node.facesBegin, AlongTheLongestAxis{centres, node.bounds});
        if (nodes.size() < 2 * i + 3)
            nodes.resize(2 * i + 3);
        const std::span<const uint32_t> all(faceIndices);
        nodes[2 * i + 1] = {boxOf(mesh, all.subspan(node.facesBegin, middle - node.facesBegin)), node.facesBegin, middle};
        nodes[2 * i + 2] = {boxOf(mesh, all.subspan(middle, node.facesEnd - middle)), middle, node.facesEnd};
    }
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
