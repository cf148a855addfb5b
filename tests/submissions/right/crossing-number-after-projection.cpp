// right: projects the face along its normal's longest axis and counts crossings in double; packed 64-bit keys decide the median
#pragma once
#include "triangle.h"
#include "ray.h"
#include "mesh.h"
#include "intersection.h"
#include "bvh.h"
#include <bit>

static_assert(sizeof(BVH::Node) == 8 * sizeof(float));
static_assert(std::numeric_limits<float>::is_iec559);

namespace {

// Floats as integers that sort alike: flip all bits of negative ones, the sign of the others.
constexpr uint32_t sortable(float value) noexcept
{
    const auto bits = std::bit_cast<uint32_t>(value);
    return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}
static_assert(sortable(-1.f) < sortable(-0.5f) && sortable(-0.5f) < sortable(0.f) && sortable(0.f) < sortable(1e30f));

[[nodiscard]] bool oddCrossings(const double (&px)[3], const double (&py)[3], double x, double y)
{
    bool odd = false;
    for (int i = 0, j = 2; i < 3; j = i++)
        if ((py[i] > y) != (py[j] > y) && x < (px[j] - px[i]) * (y - py[i]) / (py[j] - py[i]) + px[i])
            odd = !odd;
    return odd;
}

bool hitFace(const Triangle& tri, const Ray& ray, double limit, double& t)
{
    const double e[3] = {double(tri.v2.x) - tri.v1.x, double(tri.v2.y) - tri.v1.y, double(tri.v2.z) - tri.v1.z};
    const double f[3] = {double(tri.v3.x) - tri.v1.x, double(tri.v3.y) - tri.v1.y, double(tri.v3.z) - tri.v1.z};
    const double n[3] = {e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]};
    double num = 0, den = 0;
    for (int k = 0; k < 3; ++k) {
        num += (double(tri.v1[k]) - ray.origin[k]) * n[k];
        den += double(ray.direction[k]) * n[k];
    }
    if (den == 0)
        return false;
    t = num / den;
    if (!(t > ray.t_min) || !(t < limit))
        return false;
    int drop = 0;
    for (int k = 1; k < 3; ++k)
        if (std::abs(n[k]) > std::abs(n[drop]))
            drop = k;
    const int u = (drop + 1) % 3, v = (drop + 2) % 3;
    return oddCrossings({tri.v1[u], tri.v2[u], tri.v3[u]}, {tri.v1[v], tri.v2[v], tri.v3[v]},
                        ray.origin[u] + t * ray.direction[u], ray.origin[v] + t * ray.direction[v]);
}

} // namespace

void BVH::construct(const Mesh& mesh)
{
    const auto faces = std::span(mesh.getFaces());
    const auto& verts = mesh.getVertices();
    const uint32_t total = uint32_t(faces.size());
    std::vector<uint64_t> keys(total);
    for (uint64_t k = 0; k < total; ++k)
        keys[k] = k;
    nodes.clear();
    nodes.emplace_back(Node{mesh.getBounds(), 0, total});
    for (size_t first = 0, depth = 0; first < nodes.size() && depth != maxDepth; first = 2 * first + 1, ++depth) {
        const size_t last = std::min(nodes.size(), 2 * first + 1);
        for (size_t i = first; i != last; ++i) {
            const Node parent = nodes[i];
            const uint32_t size = parent.facesEnd - parent.facesBegin;
            if (size <= numFacesPerLeaf)
                continue;
            const auto part = std::span(keys).subspan(parent.facesBegin, size);
            const auto axis = parent.bounds.extents().maxDimension();
            for (uint64_t& key : part) {
                const TriangleIndices& tri = faces[uint32_t(key)];
                const float centre = (verts[tri.v1][axis] + verts[tri.v2][axis] + verts[tri.v3][axis]) / 3.f;
                key = uint64_t(sortable(centre)) << 32 | uint32_t(key);
            }
            std::nth_element(part.begin(), part.begin() + size / 2, part.end());
            if (nodes.size() < 2 * i + 3)
                nodes.resize(2 * i + 3);
            nodes[2 * i + 1] = Node{AABB{}, parent.facesBegin, parent.facesBegin + size / 2};
            nodes[2 * i + 2] = Node{AABB{}, parent.facesBegin + size / 2, parent.facesEnd};
            for (Node* child : {&nodes[2 * i + 1], &nodes[2 * i + 2]})
                for (uint32_t k = child->facesBegin; k != child->facesEnd; ++k)
                    for (uint32_t corner : {faces[uint32_t(keys[k])].v1, faces[uint32_t(keys[k])].v2, faces[uint32_t(keys[k])].v3})
                        child->bounds.extend(verts[corner]);
        }
    }
    faceIndices.assign(keys.begin(), keys.end()); // keeps the lower half
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    const auto& nodes = mesh.getBVH().getNodes();
    double closest = ray.t_max;
    const uint32_t none = ~0u;
    uint32_t winner = none;
    // bit k of the trail: at depth k the second child has been taken already
    if (nodes.empty())
        return {};
    uint32_t trail = 0, i = 0;
    int depth = 0;
    while (true) {
        bool down = false;
        if (intersect(nodes[i].bounds, ray)) {
            down = 2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd != 0;
            if (!down)
                for (const uint32_t f : mesh.getBVH().getFaceIndices(nodes[i]))
                    if (double t; hitFace(mesh.getTriangleFromFaceIndex(f), ray, closest, t)) {
                        closest = t;
                        winner = f;
                    }
        }
        if (down) {
            i = 2 * i + 1;
            trail &= ~(1u << ++depth);
            continue;
        }
        while (depth > 0 && trail >> depth & 1) {
            i = (i - 1) >> 1;
            --depth;
        }
        if (depth == 0)
            break;
        trail |= 1u << depth;
        ++i;
    }
    if (winner == none)
        return {};
    const Triangle tri = mesh.getTriangleFromFaceIndex(winner);
    const float t = static_cast<float>(closest);
    return {.intersection_point = ray.origin + t * ray.direction, .t = t, .normal = cross(tri.v1v2, tri.v1v3).normalized()};
}
