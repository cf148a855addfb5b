// The same exercise once more, as fast as its tree allows. Read ../src/exercise03.cpp first: both
// build the same tree, bit by bit, and find the same hits. ../README.md explains every step.
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <cstring>

namespace {

/// Four numbers: an operation does to each of them what it does to one, in the same time. What a
/// comparison gives is a mask: in each lane all bits are set where it holds, else none.
using Float4 = float __attribute__((vector_size(16)));
using Mask4 = int32_t __attribute__((vector_size(16)));

/// One bit for each lane in which the mask holds, so that four questions are one `if`.
uint32_t lanesOf(Mask4 mask) {
#ifdef __SSE__
    Float4 signs;
    std::memcpy(&signs, &mask, sizeof signs);
    return static_cast<uint32_t>(__builtin_ia32_movmskps(signs));
#else
    return (mask[0] & 1U) | (mask[1] & 2U) | (mask[2] & 4U) | (mask[3] & 8U);
#endif
}

/// Four points. Each operator does what that of `Point3D` does, in the same order, so that a hit
/// has the same bits as one from the given test.
struct Points4 {
    Float4 x, y, z;
    Points4 operator+(const Points4& b) const { return {x + b.x, y + b.y, z + b.z}; }
    Points4 operator-(const Points4& b) const { return {x - b.x, y - b.y, z - b.z}; }
    Points4 operator*(Float4 s) const { return {x * s, y * s, z * s}; }
    Float4 dot(const Points4& b) const { return x * b.x + y * b.y + z * b.z; }
    Points4 cross(const Points4& b) const {
        return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x};
    }
};

Points4 together(const Point3D& a, const Point3D& b, const Point3D& c, const Point3D& d) {
    return {Float4{a.x, b.x, c.x, d.x}, Float4{a.y, b.y, c.y, d.y}, Float4{a.z, b.z, c.z, d.z}};
}

Points4 all(const Point3D& p) {
    return together(p, p, p, p);
}

Float4 all(float value) {
    return Float4{value, value, value, value};
}

/// What splitting moves: a box, and the centre on one axis. 32 bytes, half a line of the cache.
struct Face {
    Point3D low;
    uint32_t index;
    Point3D high;
    float center;
};
static_assert(offsetof(Face, high) == sizeof(Float4) && sizeof(Face) == 2 * sizeof(Float4));

/// The centres come axis by axis: asking for one axis reads nothing of the others.
std::vector<Face> facesOf(const Mesh& mesh, std::array<std::vector<float>, 3>& centers) {
    std::vector<Face> faces;
    faces.reserve(mesh.getFaces().size());
    for (uint32_t i = 0; i < mesh.getFaces().size(); ++i) {
        const auto& [a, b, c, ab, ac] = mesh.getTriangleFromFaceIndex(i);
        const Point3D center = (a + b + c) / 3;
        for (size_t axis = 0; axis < 3; ++axis) {
            centers[axis].push_back(center[axis]);
        }
        faces.push_back({min(min(a, b), c), i, max(max(a, b), c), 0});
    }
    return faces;
}

/// The fourth lanes hold what follows a corner in `Face`; nobody looks at them.
AABB boundsOf(std::span<const Face> faces) {
    Float4 low = all(+infinity);
    Float4 high = all(-infinity);
    for (const Face& face : faces) {
        std::array<Float4, 2> corners;
        std::memcpy(&corners, &face, sizeof corners);
        low = corners[0] < low ? corners[0] : low;
        high = high < corners[1] ? corners[1] : high;
    }
    return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

/// As in the given test, how much rounding may move the far side of a box: 2 gamma(3).
constexpr float unit = std::numeric_limits<float>::epsilon() / 2;
constexpr float slabSlack = 2 * (3 * unit) / (1 - 3 * unit);

/// Exchanges rows and columns.
void transpose(std::array<Float4, 4>& m) {
    const Float4 a = __builtin_shufflevector(m[0], m[1], 0, 4, 1, 5);
    const Float4 b = __builtin_shufflevector(m[2], m[3], 0, 4, 1, 5);
    const Float4 c = __builtin_shufflevector(m[0], m[1], 2, 6, 3, 7);
    const Float4 d = __builtin_shufflevector(m[2], m[3], 2, 6, 3, 7);
    m = {__builtin_shufflevector(a, b, 0, 1, 4, 5), __builtin_shufflevector(a, b, 2, 3, 6, 7),
         __builtin_shufflevector(c, d, 0, 1, 4, 5), __builtin_shufflevector(c, d, 2, 3, 6, 7)};
}

bool areUsed(const std::vector<BVH::Node>& nodes, size_t first, size_t count) {
    return first + count <= nodes.size() && nodes[first].facesEnd != 0 &&
           nodes[first + 1].facesEnd != 0 && nodes[first + count - 2].facesEnd != 0 &&
           nodes[first + count - 1].facesEnd != 0;
}

/// A node is two registers; the tests want the same number of four nodes in one.
struct Boxes4 {
    std::array<Float4, 4> front; // x, y, z of the lower corners, x of the upper ones
    std::array<Float4, 4> back;  // y, z of the upper corners, where the faces begin and end
    /// Of 2 or 4 nodes; two come twice.
    Boxes4(const BVH::Node* first, size_t count)
        : front{half(first, 0), half(first + 1, 0), half(first + count - 2, 0),
                half(first + count - 1, 0)},
          back{half(first, 1), half(first + 1, 1), half(first + count - 2, 1),
               half(first + count - 1, 1)} {
        transpose(front);
        transpose(back);
    }

    static Float4 half(const BVH::Node* node, size_t which) {
        std::array<Float4, 2> halves;
        std::memcpy(&halves, node, sizeof *node);
        return halves[which];
    }
};

/// A ray that becomes shorter with every hit, against four boxes or four faces at once.
struct Ray4 {
    Points4 origin, direction, inverse;
    Float4 begin;
    float end;
    explicit Ray4(const IntersectionRay& ray)
        : origin(all(ray.origin)), direction(all(ray.direction)), inverse(all(ray.inv_direction)),
          begin(all(ray.t_min)), end(ray.t_max) {}

    /// Cuts [near, far] to one slab. Comparing with not-a-number is false and changes nothing, as
    /// in the given test. All four lanes go the same way, so one branch does instead of masks.
    static void clip(Float4 low, Float4 high, Float4 from, Float4 inverse, Float4& near,
                     Float4& far) {
        const bool backward = inverse[0] < 0;
        const Float4 entry = ((backward ? high : low) - from) * inverse;
        const Float4 leave = ((backward ? low : high) - from) * inverse;
        near = near < entry ? entry : near;
        far = leave < far ? leave : far;
    }

    /// The lanes of the boxes that the ray meets, and where it enters each of them.
    uint32_t meets(const Boxes4& boxes, Float4& near) const {
        near = begin;
        Float4 far = all(end);
        clip(boxes.front[0], boxes.front[3], origin.x, inverse.x, near, far);
        clip(boxes.front[1], boxes.back[0], origin.y, inverse.y, near, far);
        clip(boxes.front[2], boxes.back[1], origin.z, inverse.z, near, far);
        far += (far < -far ? -far : far) * all(slabSlack);
        return lanesOf((near <= far) & (near < all(infinity)));
    }

    /// Shortens the ray to the closest hit with four faces; its lane, or 4 if there is none.
    uint32_t closest(const Points4& v1, const Points4& v2, const Points4& v3) {
        const Points4 v1v2 = v2 - v1;
        const Points4 v1v3 = v3 - v1;
        const Points4 normal = v1v2.cross(v1v3);
        const Float4 t = (v1 - origin).dot(normal) / direction.dot(normal);
        const Mask4 between = (begin < t) & (t < all(end));
        if (lanesOf(between) == 0) {
            return 4;
        }
        const Points4 point = origin + direction * t;
        const Points4 fromV1 = point - v1;
        const Mask4 inside = (normal.dot(v1v2.cross(fromV1)) >= 0) &
                             (normal.dot((v3 - v2).cross(point - v2)) >= 0) &
                             (normal.dot(fromV1.cross(v1v3)) >= 0);
        const uint32_t hits = lanesOf(between & inside);
        uint32_t found = 4;
        for (uint32_t lane = 0; lane < 4; ++lane) {
            if ((hits >> lane & 1U) != 0 && t[lane] < end) {
                end = t[lane];
                found = lane;
            }
        }
        return found;
    }
};

/// Nodes that wait, with the place where the ray enters them. Of 32 levels, two leave three nodes.
struct Stack {
    std::array<std::pair<float, uint32_t>, 64> entries;
    size_t size{0};
    /// Adds the nodes `first + lane` so that the nearest comes next.
    void push(size_t first, uint32_t lanes, Float4 near) {
        const size_t bottom = size;
        for (; lanes != 0; lanes &= lanes - 1) {
            const auto lane = static_cast<uint32_t>(std::countr_zero(lanes));
            const float at = near[lane];
            size_t place = size++;
            for (; place > bottom && entries[place - 1].first < at; --place) {
                entries[place] = entries[place - 1];
            }
            entries[place] = {at, static_cast<uint32_t>(first + lane)};
        }
    }
};

/// The closest face of a leaf that is hit, four tested at a time; `before` if there is none.
uint32_t closestFace(const Mesh& mesh, const BVH::Node& leaf, Ray4& ray, uint32_t before) {
    const std::vector<Point3D>& v = mesh.getVertices();
    const std::span<const uint32_t> faces = mesh.getBVH().getFaceIndices(leaf);
    for (size_t begin = 0; begin < faces.size(); begin += 4) {
        std::array<uint32_t, 4> index; // the last face fills the lanes that are left
        for (size_t lane = 0; lane < 4; ++lane) {
            index[lane] = faces[std::min(begin + lane, faces.size() - 1)];
        }
        const auto& [a1, a2, a3] = mesh.getFaces()[index[0]];
        const auto& [b1, b2, b3] = mesh.getFaces()[index[1]];
        const auto& [c1, c2, c3] = mesh.getFaces()[index[2]];
        const auto& [d1, d2, d3] = mesh.getFaces()[index[3]];
        const Points4 v1 = together(v[a1], v[b1], v[c1], v[d1]);
        const Points4 v2 = together(v[a2], v[b2], v[c2], v[d2]);
        const uint32_t lane = ray.closest(v1, v2, together(v[a3], v[b3], v[c3], v[d3]));
        before = lane < 4 ? index[lane] : before;
    }
    return before;
}

} // namespace

void BVH::construct(const Mesh& mesh) {
    std::array<std::vector<float>, 3> centers;
    std::vector<Face> faces = facesOf(mesh, centers);
    const auto numFaces = static_cast<uint32_t>(faces.size());
    // Halving rounds up at most, so this many leaves hold four faces each: the last level.
    const uint32_t numLeaves = std::min(
        roundUpPowerOfTwo((numFaces + numFacesPerLeaf - 1) / numFacesPerLeaf), 1U << maxDepth);
    nodes.assign(2 * size_t{numLeaves} - 1, Node{});
    nodes[0] = {mesh.getBounds(), 0, numFaces};
    constexpr uint8_t none = 3;
    std::vector<std::pair<size_t, uint8_t>> unsplit{{0, none}}; // and the axis that faces know
    while (!unsplit.empty()) {
        const auto [i, known] = unsplit.back();
        unsplit.pop_back();
        const Node& node = nodes[i];
        const std::span all =
            std::span(faces).subspan(node.facesBegin, node.facesEnd - node.facesBegin);
        const size_t left = 2 * i + 1;
        if (all.size() <= numFacesPerLeaf || left >= nodes.size()) {
            continue;
        }
        const uint8_t axis = node.bounds.extents().maxDimension();
        if (axis != known) {
            for (Face& face : all) {
                face.center = centers[axis][face.index];
            }
        }
        const auto half = static_cast<uint32_t>(all.size() / 2);
        std::nth_element(all.begin(), all.begin() + half, all.end(),
                         [](const Face& a, const Face& b) { return a.center < b.center; });
        const uint32_t middle = node.facesBegin + half;
        nodes[left] = {boundsOf(all.first(half)), node.facesBegin, middle};
        nodes[left + 1] = {boundsOf(all.subspan(half)), middle, node.facesEnd};
        unsplit.emplace_back(left + 1, axis);
        unsplit.emplace_back(left, axis);
    }
    faceIndices.resize(numFaces);
    std::ranges::transform(faces, faceIndices.begin(), &Face::index);
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const std::vector<BVH::Node>& nodes = mesh.getBVH().getNodes();
    const auto none = static_cast<uint32_t>(mesh.getFaces().size());
    uint32_t closest = none;
    Ray4 rest{ray};
    Stack waiting;
    waiting.push(0, nodes.empty() ? 0 : 1, all(ray.t_min)); // the root's box needs no test
    while (waiting.size > 0) {
        const auto [near, i] = waiting.entries[--waiting.size];
        if (near > rest.end + std::abs(rest.end) * slabSlack) {
            continue; // a hit that was found since is closer than the box
        }
        // Four grandchildren at once, past the children; near the leaves two children.
        const size_t child = 2 * size_t{i} + 1;
        const size_t count = areUsed(nodes, 2 * child + 1, 4) ? 4 : 2;
        const size_t first = count == 4 ? 2 * child + 1 : child;
        if (count == 4 || areUsed(nodes, first, count)) {
            Float4 nears;
            const uint32_t met = rest.meets(Boxes4(&nodes[first], count), nears);
            waiting.push(first, met & ((1U << count) - 1), nears);
        } else {
            closest = closestFace(mesh, nodes[i], rest, closest);
        }
    }
    if (closest == none) {
        return {};
    }
    const Triangle triangle = mesh.getTriangleFromFaceIndex(closest);
    return {ray.origin + ray.direction * rest.end, rest.end,
            cross(triangle.v1v2, triangle.v1v3).normalized()};
}
