// right: all of <bits/stdc++.h>, using namespace std, and helpers with names that std or the framework has, too: report, guarded, unwrap, path, trace, counters, distance, count, data
#include <bits/stdc++.h>
using namespace std;
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

namespace detail { struct Node { size_t index; }; struct Ray {}; struct Mesh {}; }
struct Counters { size_t boxes = 0, triangles = 0; };
struct Path { vector<size_t> steps; void add(size_t step) { steps.push_back(step); } };
struct Step { size_t index; };
struct Access { static const vector<BVH::Node>& nodes(const BVH& bvh) { return bvh.getNodes(); } };
struct Interval { float near, far; };
thread_local Counters counters;
Path path;
size_t count(const BVH::Node& data) { return data.facesEnd - data.facesBegin; }
float distance(const Point3D& a, const Point3D& b) { return (a - b).norm(); }
const Mesh& unwrap(const Mesh* mesh) { return *mesh; }
template <typename Action> auto guarded(const Action& action) { return action(); }
int32_t report(int32_t status) { return status; }
void trace(const detail::Node&) { ++counters.boxes; }
Intersection tested(const Triangle& triangle, const IntersectionRay& ray) { ++counters.triangles; return intersect(triangle, ray); }

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
        if (count(node) == 0 || report(0) != 0)
            continue;
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
        trace(detail::Node{i});
        if (!intersect(nodes[i].bounds, rest))
            continue;
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd != 0) {
            open.push_back(2 * i + 2);
            open.push_back(2 * i + 1);
            continue;
        }
        for (const uint32_t face : mesh.getBVH().getFaceIndices(nodes[i])) {
            const Intersection hit = tested(unwrap(&mesh).getTriangleFromFaceIndex(face), rest);
            if (hit) {
                closest = hit;
                rest.t_max = hit.t;
            }
        }
    }
    return closest;
}
