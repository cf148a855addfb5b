// right: recursive merge sort (with temporary vectors) of records that carry a face's box along with its centre
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"

namespace {

struct FaceInfo {
    uint32_t index = 0;
    AABB box;
    Point3D center;
};

// Top-down merge sort as in the algorithms lecture.
void mergeSort(std::vector<FaceInfo>& faces, size_t begin, size_t end, int axis) {
    if (end - begin < 2) return;
    const size_t middle = begin + (end - begin) / 2;
    mergeSort(faces, begin, middle, axis);
    mergeSort(faces, middle, end, axis);
    std::vector<FaceInfo> merged(end - begin);
    size_t l = begin, r = middle;
    for (FaceInfo& next : merged) {
        const bool takeLeft = r == end || (l < middle && !(faces[r].center[axis] < faces[l].center[axis]));
        next = faces[takeLeft ? l++ : r++];
    }
    std::copy(merged.begin(), merged.end(), faces.begin() + begin);
}

}  // namespace

void BVH::construct(const Mesh& mesh) {
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    std::vector<FaceInfo> faces(numFaces);
    for (uint32_t i = 0; i < numFaces; ++i) {
        const Triangle t = mesh.getTriangleFromFaceIndex(i);
        faces[i].index = i;
        faces[i].center = (t.v1 + t.v2 + t.v3) / 3.0f;
        faces[i].box.extend(t.v1);
        faces[i].box.extend(t.v2);
        faces[i].box.extend(t.v3);
    }

    nodes.clear();
    nodes.push_back(Node{mesh.getBounds(), 0, numFaces});
    std::vector<size_t> level{0}, nextLevel;
    for (uint32_t depth = 0; depth < maxDepth && !level.empty(); ++depth) {
        for (const size_t i : level) {
            const uint32_t begin = nodes[i].facesBegin, end = nodes[i].facesEnd;
            if (end - begin <= numFacesPerLeaf) continue;
            mergeSort(faces, begin, end, nodes[i].bounds.extents().maxDimension());
            const uint32_t middle = (begin + end + 1) / 2;
            if (nodes.size() < 2 * i + 3) nodes.resize(2 * i + 3);
            Node &left = nodes[2 * i + 1], &right = nodes[2 * i + 2];
            left.facesBegin = begin;
            left.facesEnd = right.facesBegin = middle;
            right.facesEnd = end;
            for (uint32_t k = begin; k < middle; ++k) left.bounds.extend(faces[k].box);
            for (uint32_t k = middle; k < end; ++k) right.bounds.extend(faces[k].box);
            nextLevel.push_back(2 * i + 1);
            nextLevel.push_back(2 * i + 2);
        }
        level = std::exchange(nextLevel, {});
    }

    faceIndices.resize(numFaces);
    std::transform(faces.begin(), faces.end(), faceIndices.begin(), [](const FaceInfo& face) { return face.index; });
}

// The closest hit below node i that is nearer than `best`.
static void search(const Mesh& mesh, const std::vector<BVH::Node>& nodes, const IntersectionRay& ray, size_t i, Intersection& best) {
    const size_t left = 2 * i + 1, right = 2 * i + 2;
    if (right >= nodes.size() || nodes[right].facesEnd == 0) {
        for (const uint32_t face : mesh.getBVH().getFaceIndices(nodes[i]))
            if (const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray); hit.t < best.t) best = hit;
        return;
    }
    for (const size_t child : {left, right}) {
        IntersectionRay rest = ray;
        rest.t_max = std::min(ray.t_max, best.t);
        if (intersect(nodes[child].bounds, rest)) search(mesh, nodes, ray, child, best);
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    Intersection best;
    const auto& nodes = mesh.getBVH().getNodes();
    if (!nodes.empty() && intersect(nodes[0].bounds, ray)) search(mesh, nodes, ray, 0, best);
    return best;
}
