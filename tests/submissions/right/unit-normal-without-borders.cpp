// right: an own triangle test with a unit normal, which takes the border of a face for outside
#include "intersection.h"
#include "bvh.h"
#include "mesh.h"

struct Part {
    size_t node;
    uint32_t level;
};

void BVH::construct(const Mesh& mesh) {
    const auto& faces = mesh.getFaces();
    std::vector<std::array<double, 3>> centres;
    faceIndices.clear();
    for (const TriangleIndices& face : faces) {
        const auto& v = mesh.getVertices();
        std::array<double, 3> centre{};
        for (int axis = 0; axis < 3; ++axis)
            centre[axis] = (double(v[face.v1][axis]) + v[face.v2][axis] + v[face.v3][axis]) / 3;
        centres.push_back(centre);
        faceIndices.push_back(uint32_t(faceIndices.size()));
    }
    nodes.clear();
    nodes.push_back({mesh.getBounds(), 0, uint32_t(faces.size())});
    std::queue<Part> parts;
    parts.push({0, 0});
    for (; !parts.empty(); parts.pop()) {
        const auto [index, level] = parts.front();
        const Node node = nodes[index];
        const size_t count = node.facesEnd - node.facesBegin;
        if (level == maxDepth || count <= numFacesPerLeaf)
            continue;
        const uint8_t axis = node.bounds.extents().maxDimension();
        const auto begin = faceIndices.begin() + node.facesBegin;
        std::stable_sort(begin, begin + count, [&](uint32_t a, uint32_t b) {
            return centres[a][axis] < centres[b][axis];
        });
        Node left{{}, node.facesBegin, node.facesBegin + uint32_t(count / 2)};
        Node right{{}, left.facesEnd, node.facesEnd};
        for (Node* half : {&left, &right})
            for (uint32_t k = half->facesBegin; k != half->facesEnd; ++k) {
                const Triangle t = mesh.getTriangleFromFace(faces[faceIndices[k]]);
                half->bounds.extend({min(min(t.v1, t.v2), t.v3), max(max(t.v1, t.v2), t.v3)});
            }
        nodes.resize(std::max(nodes.size(), 2 * index + 3));
        nodes[2 * index + 1] = left;
        nodes[2 * index + 2] = right;
        parts.push({2 * index + 1, level + 1});
        parts.push({2 * index + 2, level + 1});
    }
}

// Inside means: on the inner side of every edge, and not on the edge itself.
static Intersection strictly(const Triangle& t, const IntersectionRay& ray) {
    const Normal3D n = cross(t.v1v2, t.v1v3).normalized();
    const float distance = dot(t.v1 - ray.origin, n) / dot(ray.direction, n);
    if (!(distance > ray.t_min) || distance >= ray.t_max)
        return {};
    const Point3D p = ray.origin + ray.direction * distance;
    const float a = dot(cross(t.v1v2, p - t.v1), n);
    const float b = dot(cross(t.v3 - t.v2, p - t.v2), n);
    const float c = dot(cross(t.v1 - t.v3, p - t.v3), n);
    if (a > 0 && b > 0 && c > 0)
        return {p, distance, n};
    return {};
}

static void visit(const Mesh& mesh, const IntersectionRay& ray, size_t i, Intersection& best) {
    const auto& nodes = mesh.getBVH().getNodes();
    if (!intersect(nodes[i].bounds, ray))
        return;
    const size_t left = 2 * i + 1, right = left + 1;
    if (left < nodes.size() && right < nodes.size() && nodes[left].facesEnd && nodes[right].facesEnd) {
        visit(mesh, ray, left, best);
        visit(mesh, ray, right, best);
        return;
    }
    for (auto face : mesh.getBVH().getFaceIndices(nodes[i]))
        if (const Intersection hit = strictly(mesh.getTriangleFromFaceIndex(face), ray); hit.t < best.t)
            best = hit;
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    Intersection best;
    if (!mesh.getBVH().getNodes().empty())
        visit(mesh, ray, 0, best);
    return best;
}
