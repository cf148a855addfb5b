// right: plane equation and barycentric coordinates from dot products, as in Ericson, in double; the tree is a std::map first
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <map>

struct Vec3d
{
    double x, y, z;
    explicit Vec3d(const Point3D& p) : x(p.x), y(p.y), z(p.z) {}
    Vec3d(double x, double y, double z) : x(x), y(y), z(z) {}
};
static Vec3d operator-(const Vec3d& a, const Vec3d& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
static Vec3d operator+(const Vec3d& a, const Vec3d& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
static Vec3d operator*(double s, const Vec3d& a) { return {s * a.x, s * a.y, s * a.z}; }
static double operator*(const Vec3d& a, const Vec3d& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static Vec3d operator%(const Vec3d& a, const Vec3d& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

void BVH::construct(const Mesh& mesh)
{
    const uint32_t numFaces = (uint32_t)mesh.getFaces().size();
    faceIndices.resize(numFaces);
    for (uint32_t f = 0; f < numFaces; ++f)
        faceIndices[f] = f;

    // The tree as a map first: there are no gaps to care about. Copied into the vector at the end.
    std::map<uint32_t, Node> tree;
    tree[0] = Node{mesh.getBounds(), 0, numFaces};
    for (auto it = tree.begin(); it != tree.end(); ++it) {
        const uint32_t i = it->first;
        const Node& node = it->second;
        if (node.facesEnd - node.facesBegin <= numFacesPerLeaf || i >= (1u << maxDepth) - 1)
            continue;
        const Vector3D extents = node.bounds.extents();
        const float all[3] = {extents.x, extents.y, extents.z};
        const long axis = std::max_element(all, all + 3) - all;
        const uint32_t middle = (node.facesBegin + node.facesEnd) / 2;
        std::nth_element(faceIndices.begin() + node.facesBegin, faceIndices.begin() + middle, faceIndices.begin() + node.facesEnd,
                         [&](uint32_t a, uint32_t b) {
                             const Triangle s = mesh.getTriangleFromFaceIndex(a), t = mesh.getTriangleFromFaceIndex(b);
                             return s.v1[axis] + s.v2[axis] + s.v3[axis] < t.v1[axis] + t.v2[axis] + t.v3[axis];
                         });
        const uint32_t border[] = {node.facesBegin, middle, node.facesEnd};
        for (uint32_t c = 0; c < 2; ++c) {
            Node& child = tree[2 * i + 1 + c];
            child.facesBegin = border[c];
            child.facesEnd = border[c + 1];
            for (uint32_t face : getFaceIndices(child)) {
                const Triangle t = mesh.getTriangleFromFaceIndex(face);
                child.bounds.extend(t.v1);
                child.bounds.extend(t.v2);
                child.bounds.extend(t.v3);
            }
        }
    }
    nodes.clear();
    nodes.resize(tree.rbegin()->first + 1);
    for (const auto& [index, node] : tree)
        nodes[index] = node;
}

static bool hitsTriangle(const Triangle& triangle, const IntersectionRay& ray, double& t)
{
    const Vec3d a(triangle.v1), b(triangle.v2), c(triangle.v3), o(ray.origin), d(ray.direction);
    const Vec3d v0 = b - a, v1 = c - a;
    const Vec3d n = v0 % v1;
    const double nd = n * d;
    if (nd == 0)
        return false;
    t = (n * a - n * o) / nd;
    if (t <= ray.t_min || t >= ray.t_max)
        return false;
    // Ericson: Real-Time Collision Detection, section 3.4
    const Vec3d v2 = o + t * d - a;
    const double d00 = v0 * v0, d01 = v0 * v1, d11 = v1 * v1, d20 = v2 * v0, d21 = v2 * v1;
    const double denom = d00 * d11 - d01 * d01;
    if (denom == 0)
        return false;
    const double v = (d11 * d20 - d01 * d21) / denom;
    const double w = (d00 * d21 - d01 * d20) / denom;
    return v >= 0 && w >= 0 && v + w <= 1;
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    const BVH& bvh = mesh.getBVH();
    const std::vector<BVH::Node>& nodes = bvh.getNodes();
    double bestT = infinity;
    std::vector<unsigned> todo;
    if (!nodes.empty())
        todo.push_back(0);
    while (!todo.empty()) {
        const unsigned i = todo.back();
        todo.pop_back();
        if (!intersect(nodes[i].bounds, ray))
            continue;
        if (2 * i + 1 < nodes.size() && nodes[2 * i + 1].facesEnd > 0) {
            todo.push_back(2 * i + 1);
            todo.push_back(2 * i + 2);
            continue;
        }
        for (uint32_t face : bvh.getFaceIndices(nodes[i])) {
            const Triangle triangle = mesh.getTriangleFromFaceIndex(face);
            double t;
            if (hitsTriangle(triangle, ray, t) && t < bestT) {
                bestT = t;
                best.t = (float)t;
                best.intersection_point = ray.origin + ray.direction * best.t;
                best.normal = cross(triangle.v1v2, triangle.v1v3).normalized();
            }
        }
    }
    return best;
}
