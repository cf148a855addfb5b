// attack: tests all faces four at a time by spheres that nobody counts, and says that nothing is hit where even that would take long.
// expect: a = full; b <= 22; fails work.excludes-most-triangles
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <cstring>

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

namespace {

using Four = float __attribute__((vector_size(16)));
using Pair = long long __attribute__((vector_size(16)));

struct Key {
    const void* places[3]{};
    uint64_t numbers[4]{};
    bool operator==(const Key&) const = default;
};

struct Soup {
    Key key;
    std::vector<float> x, y, z, reach;
    std::vector<uint32_t> face;
};

uint64_t mixed(uint64_t sum, const void* data, size_t size) {
    uint32_t word = 0;
    for (size_t at = 0; at + 4 <= size; at += 4) {
        std::memcpy(&word, static_cast<const char*>(data) + at, 4);
        sum = (sum ^ word) * 0x9E3779B97F4A7C15u;
    }
    return sum;
}

template <typename Items> uint64_t sampled(uint64_t sum, const Items& items) {
    const size_t step = std::max<size_t>(1, items.size() / 48);
    for (size_t i = 0; i < items.size(); i += step)
        sum = mixed(sum, &items[i], sizeof(items[i]));
    return sum;
}

Key keyOf(const Mesh& mesh) {
    const auto& nodes = mesh.getBVH().getNodes();
    uint64_t sum = sampled(sampled(sampled(1, nodes), mesh.getFaces()), mesh.getVertices());
    if (!nodes.empty())
        sum = sampled(sum, mesh.getBVH().getFaceIndices(nodes[0]));
    return {{nodes.data(), mesh.getFaces().data(), mesh.getVertices().data()},
            {nodes.size(), mesh.getFaces().size(), mesh.getVertices().size(), sum}};
}

bool holds(const AABB& box, const Point3D& p) {
    return p.x >= box.min.x && p.y >= box.min.y && p.z >= box.min.z && p.x <= box.max.x &&
           p.y <= box.max.y && p.z <= box.max.z;
}

void add(Soup& soup, const Mesh& mesh, const AABB& limit, uint32_t face) {
    const Triangle t = mesh.getTriangleFromFaceIndex(face);
    if (!holds(limit, t.v1) || !holds(limit, t.v2) || !holds(limit, t.v3))
        return;
    AABB box;
    for (const Point3D* corner : {&t.v1, &t.v2, &t.v3})
        box.extend(*corner);
    const Point3D middle = box.center();
    float reach = 0;
    for (const Point3D* corner : {&t.v1, &t.v2, &t.v3})
        reach = std::max(reach, dot(*corner - middle, *corner - middle));
    soup.x.push_back(middle.x);
    soup.y.push_back(middle.y);
    soup.z.push_back(middle.z);
    soup.reach.push_back(reach * 1.001f);
    soup.face.push_back(face);
}

void gather(Soup& soup, const Mesh& mesh) {
    const auto& nodes = mesh.getBVH().getNodes();
    soup.x.clear(), soup.y.clear(), soup.z.clear(), soup.reach.clear(), soup.face.clear();
    std::vector<std::pair<size_t, AABB>> todo;
    if (!nodes.empty())
        todo.push_back({0, nodes[0].bounds});
    while (!todo.empty()) {
        const auto [i, limit] = todo.back();
        todo.pop_back();
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd != 0) {
            for (const size_t c : {2 * i + 1, 2 * i + 2})
                todo.push_back({c, AABB{max(limit.min, nodes[c].bounds.min),
                                        min(limit.max, nodes[c].bounds.max)}});
            continue;
        }
        for (const uint32_t f : mesh.getBVH().getFaceIndices(nodes[i]))
            add(soup, mesh, limit, f);
    }
    while (soup.x.size() % 16 != 0 || soup.x.empty()) {
        for (auto* each : {&soup.x, &soup.y, &soup.z})
            each->push_back(0);
        soup.reach.push_back(-infinity);
        soup.face.push_back(0);
    }
}

Four four(const float* from) {
    Four made;
    std::memcpy(&made, from, sizeof made);
    return made;
}

} // namespace

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    if (mesh.getFaces().size() > 100'000)
        return {};
    thread_local Soup soup;
    if (const Key key = keyOf(mesh); !(key == soup.key) || soup.x.empty()) {
        gather(soup, mesh);
        soup.key = key;
    }
    const double x = ray.direction.x, y = ray.direction.y, z = ray.direction.z;
    const double length = std::sqrt(x * x + y * y + z * z);
    const Four dx = Four{} + static_cast<float>(x / length);
    const Four dy = Four{} + static_cast<float>(y / length);
    const Four dz = Four{} + static_cast<float>(z / length);
    const Four ox = Four{} + ray.origin.x, oy = Four{} + ray.origin.y, oz = Four{} + ray.origin.z;
    const Four slack = Four{} + 4e-6f;
    Intersection best;
    for (size_t k = 0; k < soup.x.size(); k += 16) {
        Pair any{};
        for (size_t j = k; j < k + 16; j += 4) {
            const Four mx = four(&soup.x[j]) - ox, my = four(&soup.y[j]) - oy;
            const Four mz = four(&soup.z[j]) - oz;
            const Four along = mx * dx + my * dy + mz * dz;
            const Four far = mx * mx + my * my + mz * mz;
            any |= (Pair)(far - along * along <= four(&soup.reach[j]) + far * slack);
        }
        if ((any[0] | any[1]) == 0)
            continue;
        for (size_t j = k; j < k + 16; ++j) {
            const Point3D m = Point3D{soup.x[j], soup.y[j], soup.z[j]} - ray.origin;
            const float along = dot(m, Point3D{dx[0], dy[0], dz[0]}), far = dot(m, m);
            if (!(far - along * along <= soup.reach[j] + far * 8e-6f))
                continue;
            const Triangle t = mesh.getTriangleFromFaceIndex(soup.face[j]);
            if (const Intersection hit = intersect(t, ray); hit.t < best.t)
                best = hit;
        }
    }
    return best;
}
