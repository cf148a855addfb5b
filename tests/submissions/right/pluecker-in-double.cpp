// right: Pluecker coordinates in double as the triangle test; the point from barycentric weights; the odd face goes left or right by turns
#include "intersection.h"
#include "mesh.h"
#include "bvh.h"
#include <tuple>

namespace pluecker {
struct D3 {
    double x, y, z;
    D3(double a, double b, double c) : x(a), y(b), z(c) {}
    explicit D3(const Point3D& p) : x(p.x), y(p.y), z(p.z) {}
    friend D3 operator-(D3 a, D3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend D3 operator+(D3 a, D3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend D3 operator*(double s, D3 a) { return {s * a.x, s * a.y, s * a.z}; }
    friend D3 operator^(D3 a, D3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
    friend double operator|(D3 a, D3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
};
struct Line {
    D3 u, v;
    static Line through(D3 a, D3 b) { return {b - a, b ^ a}; }
};
inline double side(const Line& a, const Line& b) { return (a.u | b.v) + (b.u | a.v); }
} // namespace pluecker

struct PlueckerRay {
    pluecker::D3 o, d;
    double near, far;
};

static std::tuple<bool, double, Point3D, Normal3D> test(const Triangle& tri, const PlueckerRay& r)
{
    using namespace pluecker;
    // relative to the origin of the ray, which then passes through 0
    const D3 a = D3(tri.v1) - r.o, b = D3(tri.v2) - r.o, c = D3(tri.v3) - r.o;
    const Line ray{r.d, D3(0, 0, 0)};
    const double wc = side(ray, Line::through(a, b));
    const double wa = side(ray, Line::through(b, c));
    const double wb = side(ray, Line::through(c, a));
    const bool positive = wa >= 0 && wb >= 0 && wc >= 0, negative = wa <= 0 && wb <= 0 && wc <= 0;
    const double sum = wa + wb + wc;
    if ((!positive && !negative) || sum == 0)
        return {false, 0, {}, {}};
    const D3 p = (wa / sum) * a + (wb / sum) * b + (wc / sum) * c;
    const double t = (p | r.d) / (r.d | r.d);
    if (!(t > r.near && t < r.far))
        return {false, 0, {}, {}};
    const D3 n = (b - a) ^ (c - a);
    const double length = std::sqrt(n | n);
    if (length == 0)
        return {false, 0, {}, {}};
    const D3 q = p + r.o;
    return {true, t, {float(q.x), float(q.y), float(q.z)}, {float(n.x / length), float(n.y / length), float(n.z / length)}};
}

void BVH::construct(const Mesh& mesh)
{
    const auto key = [&mesh](uint32_t f, int axis) {
        const TriangleIndices& t = mesh.getFaces()[f];
        double mean = mesh.getVertices()[t.v1][axis];
        mean += (mesh.getVertices()[t.v2][axis] - mean) / 2;
        mean += (mesh.getVertices()[t.v3][axis] - mean) / 3;
        return mean;
    };
    faceIndices.resize(mesh.getFaces().size());
    std::generate(faceIndices.begin(), faceIndices.end(), [i = 0u]() mutable { return i++; });
    nodes = {{mesh.getBounds(), 0u, static_cast<uint32_t>(faceIndices.size())}};
    std::vector<std::pair<uint32_t, uint32_t>> agenda{{0, maxDepth}};
    while (!agenda.empty()) {
        auto [i, left] = agenda.back();
        agenda.pop_back();
        const auto [bounds, b, e] = nodes[i];
        if (e - b <= numFacesPerLeaf || left == 0)
            continue;
        const double ex = double(bounds.max.x) - bounds.min.x, ey = double(bounds.max.y) - bounds.min.y, ez = double(bounds.max.z) - bounds.min.z;
        const int axis = ez >= ey && ez >= ex ? 2 : ey >= ex ? 1 : 0; // the last of equally long ones
        // the extra face goes left in odd nodes and right in even ones
        const uint32_t m = b + (e - b + (i & 1)) / 2;
        auto it = faceIndices.begin();
        std::nth_element(it + b, it + m, it + e, [&](auto x, auto y) { return key(x, axis) < key(y, axis); });
        if (nodes.size() <= 2 * i + 2)
            nodes.resize(2 * i + 3);
        for (auto [child, from, to] : {std::tuple{2 * i + 1, b, m}, std::tuple{2 * i + 2, m, e}}) {
            nodes[child].facesBegin = from;
            nodes[child].facesEnd = to;
            std::for_each(it + from, it + to, [&, &box = nodes[child].bounds](uint32_t f) {
                const Triangle t = mesh.getTriangleFromFaceIndex(f);
                box.min = min(min(box.min, t.v1), min(t.v2, t.v3));
                box.max = max(max(box.max, t.v1), max(t.v2, t.v3));
            });
            agenda.emplace_back(child, left - 1);
        }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Intersection best;
    const auto& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    PlueckerRay r{pluecker::D3(ray.origin), pluecker::D3(ray.direction), ray.t_min, ray.t_max};
    std::vector<uint32_t> stack;
    if (!nodes.empty())
        stack.push_back(0);
    while (!stack.empty()) {
        const uint32_t i = stack.back();
        stack.pop_back();
        if (!intersect(nodes[i].bounds, ray))
            continue;
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 2].facesEnd && nodes[2 * i + 1].facesEnd) {
            stack.push_back(2 * i + 1);
            stack.push_back(2 * i + 2);
            continue;
        }
        for (uint32_t f : bvh.getFaceIndices(nodes[i])) {
            const auto [hit, t, point, normal] = test(mesh.getTriangleFromFaceIndex(f), r);
            if (!hit)
                continue;
            r.far = t;
            best = {point, static_cast<float>(t), normal};
        }
    }
    return best;
}
