// right: a stack of 16 KiB and a generator of 5,000 bytes for the pivots, both thread_local
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <array>
#include <random>

namespace {

thread_local std::mt19937 pivots{42};
thread_local std::array<uint32_t, 4096> todo;

/// Orders the faces so that those before `middle` are not larger than those from there on.
template <class Less>
void quickselect(std::span<uint32_t> faces, size_t middle, const Less& less) {
    size_t begin = 0, end = faces.size();
    while (end - begin > 1) {
        const uint32_t pivot = faces[begin + pivots() % (end - begin)];
        size_t smaller = begin, k = begin, larger = end;
        while (k < larger) {
            if (less(faces[k], pivot)) {
                std::swap(faces[k++], faces[smaller++]);
            } else if (less(pivot, faces[k])) {
                std::swap(faces[k], faces[--larger]);
            } else {
                ++k;
            }
        }
        if (middle < smaller) {
            end = smaller;
        } else if (middle >= larger) {
            begin = larger;
        } else {
            return;
        }
    }
}

} // namespace

void BVH::construct(const Mesh& mesh) {
    const auto count = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(count);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.assign(1, Node{mesh.getBounds(), 0, count});
    if (count == 0) {
        nodes.clear();
        return;
    }
    std::vector<Vector3D> centers(count);
    for (uint32_t face = 0; face < count; ++face) {
        const Triangle t = mesh.getTriangleFromFaceIndex(face);
        centers[face] = ((t.v1 - Point3D{}) + (t.v2 - Point3D{}) + (t.v3 - Point3D{})) / 3.0f;
    }
    size_t first = 0;
    for (uint32_t depth = 0; depth < maxDepth; ++depth) {
        const size_t next = 2 * first + 1;
        bool divided = false;
        for (size_t i = first; i < next; ++i) {
            if (i >= nodes.size() || nodes[i].facesEnd - nodes[i].facesBegin <= numFacesPerLeaf) {
                continue;
            }
            const Node parent = nodes[i];
            const std::span<uint32_t> faces{faceIndices.data() + parent.facesBegin,
                                            parent.facesEnd - parent.facesBegin};
            const size_t middle = faces.size() / 2;
            const auto axis = parent.bounds.extents().maxDimension();
            quickselect(faces, middle, [&](uint32_t a, uint32_t b) {
                return centers[a][axis] < centers[b][axis];
            });
            if (nodes.size() < 2 * next + 1) {
                nodes.resize(2 * next + 1);
            }
            const auto split = static_cast<uint32_t>(parent.facesBegin + middle);
            Node left{{}, parent.facesBegin, split}, right{{}, split, parent.facesEnd};
            for (size_t k = 0; k < faces.size(); ++k) {
                const Triangle t = mesh.getTriangleFromFaceIndex(faces[k]);
                AABB& bounds = k < middle ? left.bounds : right.bounds;
                bounds.extend(t.v1);
                bounds.extend(t.v2);
                bounds.extend(t.v3);
            }
            nodes[2 * i + 1] = left;
            nodes[2 * i + 2] = right;
            divided = true;
        }
        if (!divided) {
            break;
        }
        first = next;
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const BVH& bvh = mesh.getBVH();
    const std::vector<BVH::Node>& nodes = bvh.getNodes();
    Intersection closest;
    size_t waiting = 0;
    if (!nodes.empty()) {
        todo[waiting++] = 0;
    }
    while (waiting > 0) {
        const uint32_t i = todo[--waiting];
        if (!intersect(nodes[i].bounds, ray)) {
            continue;
        }
        const uint32_t left = 2 * i + 1, right = 2 * i + 2;
        if (right < nodes.size() && nodes[left].facesEnd != 0) {
            todo[waiting++] = right;
            todo[waiting++] = left;
            continue;
        }
        for (const uint32_t face : bvh.getFaceIndices(nodes[i])) {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
            if (hit.t < closest.t) {
                closest = hit;
            }
        }
    }
    return closest;
}
