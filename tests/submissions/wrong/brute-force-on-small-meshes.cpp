// expect: work.uses-the-tree
// untouched: a
// mistake: Meshes of fewer than a thousand faces are searched face by face.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <cmath>
#include <stack>

namespace my
{
struct Vec {
    double x, y, z;
    Vec(double x_, double y_, double z_) : x(x_), y(y_), z(z_) {}
    explicit Vec(const Point3D& p) : x(p.x), y(p.y), z(p.z) {}
    Vec operator-(const Vec& o) const { return {x - o.x, y - o.y, z - o.z}; }
    double operator*(const Vec& o) const { return x * o.x + y * o.y + z * o.z; }
    Vec operator%(const Vec& o) const { return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x}; }
};

class Splitter
{
  public:
    Splitter(const Mesh& mesh, int axis) : mesh_(mesh), axis_(axis) {}
    bool operator()(uint32_t a, uint32_t b) const { return center(a) < center(b); }

  private:
    double center(uint32_t face) const
    {
        const Triangle t = mesh_.getTriangleFromFaceIndex(face);
        return (double(t.v1[axis_]) + t.v2[axis_] + t.v3[axis_]) / 3;
    }
    const Mesh& mesh_;
    int axis_;
};
}  // namespace my

void BVH::construct(const Mesh& mesh)
{
    const auto n = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(n);
    std::iota(faceIndices.begin(), faceIndices.end(), uint32_t{0});
    nodes.clear();
    nodes.emplace_back(Node{mesh.getBounds(), 0, n});
    for (size_t i = 0; i < nodes.size() && i + 1 < (size_t{1} << maxDepth); i++) {
        const Node parent = nodes[i];
        if (parent.facesEnd - parent.facesBegin <= numFacesPerLeaf) continue;
        const uint32_t m = std::midpoint(parent.facesBegin, parent.facesEnd);
        const auto f = faceIndices.begin();
        std::nth_element(f + parent.facesBegin, f + m, f + parent.facesEnd,
                         my::Splitter(mesh, parent.bounds.extents().maxDimension()));
        Node l{{}, parent.facesBegin, m}, r{{}, m, parent.facesEnd};
        for (Node* c : {&l, &r})
            for (auto face : getFaceIndices(*c)) {
                const Triangle t = mesh.getTriangleFromFaceIndex(face);
                c->bounds.extend(t.v1), c->bounds.extend(t.v2), c->bounds.extend(t.v3);
            }
        if (nodes.size() < 2 * i + 3) nodes.resize(2 * i + 3);
        nodes[2 * i + 1] = l;
        nodes[2 * i + 2] = r;
    }
}

static double hitAt(const Triangle& t, const IntersectionRay& ray)
{
    using my::Vec;
    const Vec a(t.v1), e1 = Vec(t.v2) - a, e2 = Vec(t.v3) - a, d(ray.direction), s = Vec(ray.origin) - a;
    const Vec p = d % e2;
    const double det = e1 * p;
    if (det == 0) return INFINITY;
    const double u = (s * p) / det, v = (d * (s % e1)) / det;
    if (u < 0 || v < 0 || u + v > 1) return INFINITY;
    const double at = (e2 * (s % e1)) / det;
    return at > ray.t_min && at < ray.t_max ? at : INFINITY;
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    Intersection best;
    double closest = INFINITY;
    std::stack<size_t, std::vector<size_t>> todo;
    if (mesh.getFaces().size() < 1000) {
        for (size_t f = 0; f < mesh.getFaces().size(); ++f) {
            const Triangle triangle = mesh.getTriangleFromFaceIndex(f);
            if (const double t = hitAt(triangle, ray); t < closest) {
                closest = t;
                best.t = static_cast<float>(t);
                best.normal = cross(triangle.v1v2, triangle.v1v3).normalized();
                best.intersection_point = ray.origin + best.t * ray.direction;
            }
        }
        return best;
    }
    if (!nodes.empty()) todo.push(0);
    while (!todo.empty()) {
        const size_t i = todo.top();
        todo.pop();
        if (!intersect(nodes[i].bounds, ray)) continue;
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd) {
            todo.push(2 * i + 2);
            todo.push(2 * i + 1);
        } else {
            for (auto face : bvh.getFaceIndices(nodes[i])) {
                const Triangle triangle = mesh.getTriangleFromFaceIndex(face);
                if (const double t = hitAt(triangle, ray); t < closest) {
                    closest = t;
                    best.t = static_cast<float>(t);
                    best.normal = cross(triangle.v1v2, triangle.v1v3).normalized();
                    best.intersection_point = ray.origin + best.t * ray.direction;
                }
            }
        }
    }
    return best;
}
