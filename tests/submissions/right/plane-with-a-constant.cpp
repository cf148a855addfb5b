// right: an own triangle test with the plane as n.p = c in float, a textbook's form that rounds more
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

namespace {

struct Plane {
    Vector3D n;
    float c;

    explicit Plane(const Triangle& t) : n(cross(t.v1v2, t.v1v3)), c(dot(n, t.v1)) {}

    float hit(const Ray& ray) const { return (c - dot(n, ray.origin)) / dot(n, ray.direction); }
};

bool leftOf(const Point3D& from, const Point3D& to, const Point3D& p, const Vector3D& n) {
    return dot(cross(to - from, p - from), n) >= 0;
}

float centreOf(const Mesh& mesh, uint32_t face, int axis) {
    const Triangle t = mesh.getTriangleFromFaceIndex(face);
    return (t.v1[axis] + t.v2[axis] + t.v3[axis]) * (1.0f / 3.0f);
}

bool hasFaces(const std::vector<BVH::Node>& nodes, size_t i) {
    return i < nodes.size() && nodes[i].facesEnd > 0;
}

} // namespace

void BVH::construct(const Mesh& mesh) {
    const uint32_t n = uint32_t(mesh.getFaces().size());
    faceIndices.resize(n);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes = {Node{mesh.getBounds(), 0, n}};

    // Level by level: the nodes from `first` on are those of the current level.
    size_t first = 0;
    for (uint32_t depth = 0; depth < maxDepth; ++depth) {
        const size_t end = 2 * first + 1;
        bool any = false;
        for (size_t i = first; i < std::min(end, nodes.size()); ++i) {
            const Node node = nodes[i];
            const uint32_t count = node.facesEnd - node.facesBegin;
            if (count <= numFacesPerLeaf) {
                continue;
            }
            any = true;
            const int axis = node.bounds.extents().maxDimension();
            auto begin = faceIndices.begin() + node.facesBegin;
            std::sort(begin, begin + count, [&](uint32_t a, uint32_t b) {
                return centreOf(mesh, a, axis) < centreOf(mesh, b, axis);
            });
            const uint32_t middle = node.facesBegin + (count + 1) / 2;
            if (nodes.size() < 2 * i + 3) {
                nodes.resize(2 * i + 3);
            }
            Node halves[2] = {{{}, node.facesBegin, middle}, {{}, middle, node.facesEnd}};
            for (Node& half : halves) {
                for (uint32_t k = half.facesBegin; k < half.facesEnd; ++k) {
                    const Triangle t = mesh.getTriangleFromFaceIndex(faceIndices[k]);
                    half.bounds.extend(t.v1);
                    half.bounds.extend(t.v2);
                    half.bounds.extend(t.v3);
                }
            }
            nodes[2 * i + 1] = halves[0];
            nodes[2 * i + 2] = halves[1];
        }
        if (!any) {
            break;
        }
        first = end;
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const auto& nodes = mesh.getBVH().getNodes();
    Intersection best;
    std::vector<size_t> open;
    if (!nodes.empty()) {
        open.push_back(0);
    }
    while (!open.empty()) {
        const size_t i = open.back();
        open.pop_back();
        if (!intersect(nodes[i].bounds, ray)) {
            continue;
        }
        if (hasFaces(nodes, 2 * i + 1) && hasFaces(nodes, 2 * i + 2)) {
            open.push_back(2 * i + 1);
            open.push_back(2 * i + 2);
            continue;
        }
        for (const uint32_t face : mesh.getBVH().getFaceIndices(nodes[i])) {
            const Triangle t = mesh.getTriangleFromFaceIndex(face);
            const Plane plane(t);
            const float at = plane.hit(ray);
            if (!(at > ray.t_min && at < ray.t_max && at < best.t)) {
                continue;
            }
            const Point3D p = ray.origin + ray.direction * at;
            if (leftOf(t.v1, t.v2, p, plane.n) && leftOf(t.v2, t.v3, p, plane.n) &&
                leftOf(t.v3, t.v1, p, plane.n)) {
                best = {p, at, plane.n.normalized()};
            }
        }
    }
    return best;
}
