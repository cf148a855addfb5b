// attack: tests every leaf without any box test, but leaves out what lies below a box that is too small for it.
// grade: bvh.rebuild-starts-afresh, work.uses-the-tree, work.excludes-most-triangles
// expect: a = full; b <= 21; fails work.uses-the-tree; fails work.excludes-most-triangles
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

void BVH::construct(const Mesh& mesh) {
    const auto count = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(count);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.assign(1, Node{mesh.getBounds(), 0, count});
    for (size_t i = 0; i < nodes.size() && i + 1 < size_t{1} << maxDepth; ++i) {
        const auto [bounds, begin, end] = nodes[i];
        if (end - begin <= numFacesPerLeaf)
            continue;
        const uint8_t axis = bounds.extents().maxDimension();
        const auto key = [&mesh, axis](uint32_t f) {
            const Triangle t = mesh.getTriangleFromFaceIndex(f);
            return (t.v1[axis] + t.v2[axis] + t.v3[axis]) / 3;
        };
        const auto all = faceIndices.begin();
        const uint32_t middle = begin + (end - begin) / 2;
        std::nth_element(all + begin, all + middle, all + end,
                         [&key](uint32_t a, uint32_t b) { return key(a) < key(b); });
        nodes.resize(std::max(nodes.size(), 2 * i + 3));
        nodes[2 * i + 1] = {{}, begin, middle};
        nodes[2 * i + 2] = {{}, middle, end};
        for (Node* child : {&nodes[2 * i + 1], &nodes[2 * i + 2]})
            for (const uint32_t f : getFaceIndices(*child))
                for (const Triangle t = mesh.getTriangleFromFaceIndex(f);
                     const Point3D& corner : {t.v1, t.v2, t.v3})
                    child->bounds.extend(corner);
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const auto& nodes = mesh.getBVH().getNodes();
    const auto holds = [](const AABB& box, const Point3D& p) {
        return p.x >= box.min.x && p.y >= box.min.y && p.z >= box.min.z && p.x <= box.max.x &&
               p.y <= box.max.y && p.z <= box.max.z;
    };
    Intersection best;
    std::vector<size_t> todo{0};
    while (!todo.empty()) {
        const size_t i = todo.back();
        todo.pop_back();
        if (i >= nodes.size() || nodes[i].facesEnd == 0)
            continue;
        bool sound = true;
        for (size_t c = 4 * i + 3; c < 4 * i + 7; ++c)
            if (c < nodes.size() && nodes[c].facesEnd != 0)
                sound &= holds(nodes[i].bounds, nodes[c].bounds.min) &&
                         holds(nodes[i].bounds, nodes[c].bounds.max);
        if (!sound)
            continue;
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 2].facesEnd != 0) {
            todo.insert(todo.end(), {2 * i + 2, 2 * i + 1});
            continue;
        }
        for (const uint32_t f : mesh.getBVH().getFaceIndices(nodes[i])) {
            const Triangle t = mesh.getTriangleFromFaceIndex(f);
            const Vector3D p = cross(ray.direction, t.v1v3), s = ray.origin - t.v1;
            const Vector3D q = cross(s, t.v1v2);
            const float scale = 1 / dot(t.v1v2, p);
            const float u = dot(s, p) * scale, v = dot(ray.direction, q) * scale;
            const float hit = dot(t.v1v3, q) * scale;
            if (u >= 0 && v >= 0 && u + v <= 1 && hit > ray.t_min && hit < std::min(best.t, ray.t_max))
                best = {ray.origin + ray.direction * hit, hit, cross(t.v1v2, t.v1v3).normalized()};
        }
    }
    return best;
}
