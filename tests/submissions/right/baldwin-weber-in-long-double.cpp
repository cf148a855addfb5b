// right: the face as a 3 x 4 matrix that maps it to the unit triangle (Baldwin and Weber), in long double; a memo table of centres; unit tests under #ifdef
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <memory>
#include <unordered_map>

typedef long double real;

class Matrix {
    real m[3][4];

  public:
    bool make(const Triangle& tri) {
        real e1[3], e2[3], n[3], origin[3];
        for (int k = 0; k < 3; ++k) {
            origin[k] = tri.v1[k];
            e1[k] = real(tri.v2[k]) - real(tri.v1[k]);
            e2[k] = real(tri.v3[k]) - real(tri.v1[k]);
        }
        crossed(e1, e2, n);
        const real nn = dotted(n, n);
        if (nn == 0)
            return false;
        // the rows of the inverse of (e1 e2 n)
        crossed(e2, n, m[0]);
        crossed(n, e1, m[1]);
        for (int k = 0; k < 3; ++k)
            m[2][k] = n[k];
        for (auto& row : m) {
            for (int k = 0; k < 3; ++k)
                row[k] /= nn;
            row[3] = -dotted(row, origin);
        }
        return true;
    }
    void point(const Point3D& p, real (&out)[3]) const {
        for (int k = 0; k < 3; ++k)
            out[k] = m[k][0] * p.x + m[k][1] * p.y + m[k][2] * p.z + m[k][3];
    }
    void vector(const Vector3D& p, real (&out)[3]) const {
        for (int k = 0; k < 3; ++k)
            out[k] = m[k][0] * p.x + m[k][1] * p.y + m[k][2] * p.z;
    }
    Normal3D normal() const {
        const real length = std::sqrt(dotted(m[2], m[2]));
        return {float(m[2][0] / length), float(m[2][1] / length), float(m[2][2] / length)};
    }

  private:
    static void crossed(const real* a, const real* b, real* out) {
        out[0] = a[1] * b[2] - a[2] * b[1];
        out[1] = a[2] * b[0] - a[0] * b[2];
        out[2] = a[0] * b[1] - a[1] * b[0];
    }
    static real dotted(const real* a, const real* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
};

static void visit(const Mesh& mesh, const IntersectionRay& ray, uint32_t face, Intersection& best) {
    Matrix matrix;
    if (!matrix.make(mesh.getTriangleFromFaceIndex(face)))
        return;
    real o[3], d[3];
    matrix.point(ray.origin, o);
    matrix.vector(ray.direction, d);
    if (d[2] == 0)
        return;
    const real t = -o[2] / d[2];
    if (!(t > ray.t_min && t < ray.t_max && t < best.t))
        return;
    const real u = o[0] + t * d[0], v = o[1] + t * d[1];
    if (u < 0 || v < 0 || u + v > 1)
        return;
    best.t = float(t);
    best.intersection_point = ray.origin + ray.direction * best.t;
    best.normal = matrix.normal();
}

void BVH::construct(const Mesh& mesh) {
    nodes = std::vector<Node>{{mesh.getBounds(), 0, (uint32_t)mesh.getFaces().size()}};
    std::vector<uint32_t> order(mesh.getFaces().size());
    for (size_t k = order.size(); k-- > 0;)
        order[k] = (uint32_t)k;
    faceIndices.swap(order);

    std::unordered_map<uint64_t, double> memo; // of this mesh only
    auto centre = [&memo, &mesh](uint32_t f, int axis) -> double {
        const auto [it, isNew] = memo.try_emplace(uint64_t(f) << 2 | axis);
        if (isNew) {
            const Triangle t = mesh.getTriangleFromFaceIndex(f);
            it->second = (double(t.v1[axis]) + double(t.v2[axis]) + double(t.v3[axis])) / 3.0;
        }
        return it->second;
    };
    struct Entry { double key; uint32_t face; };
    std::vector<Entry> entries;
    std::vector<uint8_t> depth{0};
    for (size_t i = 0; i < nodes.size(); ++i) {
        const uint32_t b = nodes[i].facesBegin, e = nodes[i].facesEnd;
        if (e - b <= numFacesPerLeaf || depth[i] == maxDepth)
            continue;
        const AABB& box = nodes[i].bounds;
        int axis = 0;
        real longest = real(box.max.x) - box.min.x;
        for (int k = 1; k < 3; ++k)
            if (real(box.max[k]) - box.min[k] >= longest)
                longest = real(box.max[axis = k]) - box.min[k];
        entries.clear();
        for (uint32_t f : getFaceIndices(nodes[i]))
            entries.push_back({centre(f, axis), f});
        std::partial_sort(entries.begin(), entries.begin() + (e - b) / 2, entries.end(), [](const Entry& l, const Entry& r) { return l.key < r.key; });
        for (uint32_t k = b; k < e; ++k)
            faceIndices[k] = entries[k - b].face;
        const size_t left = 2 * i + 1;
        if (nodes.size() < left + 2) {
            nodes.resize(left + 2);
            depth.resize(left + 2);
        }
        for (size_t c : {left, left + 1}) {
            Node& child = nodes[c];
            child.facesBegin = c == left ? b : b + (e - b) / 2;
            child.facesEnd = c == left ? b + (e - b) / 2 : e;
            for (uint32_t f : getFaceIndices(child)) {
                const Triangle t = mesh.getTriangleFromFaceIndex(f);
                child.bounds.extend(AABB{t.v1, t.v1});
                child.bounds.extend(AABB{t.v2, t.v2});
                child.bounds.extend(AABB{t.v3, t.v3});
            }
            depth[c] = depth[i] + 1;
        }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    Intersection best;
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    std::vector<std::unique_ptr<size_t>> stack; // old habits
    if (!nodes.empty())
        stack.push_back(std::make_unique<size_t>(0));
    while (!stack.empty()) {
        const auto i = std::move(stack.back());
        stack.pop_back();
        const BVH::Node& node = nodes.at(*i);
        if (!intersect(node.bounds, ray))
            continue;
        const size_t left = *i * 2 + 1, right = left + 1;
        if (right < nodes.size() && nodes[left].facesEnd > 0) {
            stack.push_back(std::make_unique<size_t>(right));
            stack.push_back(std::make_unique<size_t>(left));
        } else
            for (uint32_t face : bvh.getFaceIndices(node))
                visit(mesh, ray, face, best);
    }
    return best;
}

#ifdef EXERCISE03_UNIT_TESTS
#include <cassert>
int main() {
    Matrix matrix;
    Point3D a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
    assert(matrix.make(Triangle{a, b, c}));
    real out[3];
    matrix.point({0.25f, 0.5f, 2}, out);
    assert(out[0] == 0.25L && out[1] == 0.5L);
}
#endif
