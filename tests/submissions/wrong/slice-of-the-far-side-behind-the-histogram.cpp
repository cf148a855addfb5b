// expect: bvh.memory-is-safe
// untouched: b
// mistake: A centre in the far side of the box is counted behind the end of the histogram.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

namespace {

/// Three times the centre is as good as the centre for comparing.
Point3D centerOf(const Mesh& mesh, uint32_t face) {
    const Triangle triangle = mesh.getTriangleFromFaceIndex(face);
    return triangle.v1 + triangle.v2 + triangle.v3;
}

AABB boundsOf(const Mesh& mesh, std::span<const uint32_t> faces) {
    AABB box;
    for (const uint32_t face : faces) {
        const Triangle triangle = mesh.getTriangleFromFaceIndex(face);
        box.extend(triangle.v1);
        box.extend(triangle.v2);
        box.extend(triangle.v3);
    }
    return box;
}

} // namespace

void BVH::construct(const Mesh& mesh) {
    *this = {};
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);
    nodes.push_back(Node{mesh.getBounds(), 0, numFaces});

    std::vector<Point3D> centers(numFaces);
    for (uint32_t face = 0; face < numFaces; ++face) {
        centers[face] = centerOf(mesh, face);
    }

    for (size_t i = 0; i < nodes.size(); ++i) {
        const Node node = nodes[i];
        const uint32_t depth = std::bit_width(i + 1) - 1;
        if (node.facesEnd - node.facesBegin <= numFacesPerLeaf || depth >= maxDepth) {
            continue;
        }
        const uint8_t axis = node.bounds.extents().maxDimension();
        const uint32_t middle = node.facesBegin + (node.facesEnd - node.facesBegin) / 2;
        const auto smaller = [&](uint32_t a, uint32_t b) {
            return centers[a][axis] < centers[b][axis];
        };
        auto first = faceIndices.begin() + node.facesBegin;
        auto last = faceIndices.begin() + node.facesEnd;
        const auto median = faceIndices.begin() + middle;
        const float low = node.bounds.min[axis];
        const float extent = node.bounds.extents()[axis];
        if (last - first > 64 && extent > 0 && extent < infinity) {
            // Find the slice of the box with the median, only its faces have to be ordered.
            const auto sliceOf = [&](uint32_t face) {
                return static_cast<int>((centers[face][axis] / 3 - low) / extent * 256);
            };
            std::vector<uint32_t> slices(256);
            for (auto face = first; face != last; ++face) {
                ++slices[sliceOf(*face)];
            }
            int slice = 0;
            for (uint32_t below = slices[0]; slice < 255 && below <= middle - node.facesBegin;) {
                below += slices[++slice];
            }
            auto inFront = std::partition(
                first, last, [&](uint32_t face) { return sliceOf(face) < slice; });
            auto behind = std::partition(
                inFront, last, [&](uint32_t face) { return sliceOf(face) == slice; });
            if (inFront <= median && median < behind) {
                first = inFront;
                last = behind;
            }
        }
        std::nth_element(first, median, last, smaller);
        Node left{{}, node.facesBegin, middle};
        Node right{{}, middle, node.facesEnd};
        left.bounds = boundsOf(mesh, getFaceIndices(left));
        right.bounds = boundsOf(mesh, getFaceIndices(right));
        if (nodes.size() < 2 * i + 3) {
            nodes.resize(2 * i + 3);
        }
        nodes[2 * i + 1] = left;
        nodes[2 * i + 2] = right;
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const BVH& bvh = mesh.getBVH();
    const std::vector<BVH::Node>& nodes = bvh.getNodes();
    Intersection closest;
    if (nodes.empty()) {
        return closest;
    }

    IntersectionRay shortened = ray; // ends at the closest hit so far
    std::vector<size_t> stack{0};
    while (!stack.empty()) {
        const size_t i = stack.back();
        stack.pop_back();
        if (!intersect(nodes[i].bounds, shortened)) {
            continue;
        }
        const size_t left = 2 * i + 1;
        if (left + 1 < nodes.size() && nodes[left].facesEnd != 0) {
            stack.push_back(left + 1);
            stack.push_back(left);
            continue;
        }
        for (const uint32_t face : bvh.getFaceIndices(nodes[i])) {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), shortened);
            if (hit.t < closest.t) {
                closest = hit;
                shortened.t_max = hit.t;
            }
        }
    }
    return closest;
}
