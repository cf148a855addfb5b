// right: the textbook's triangle test by Cramer's rule (a 3 x 3 system for beta, gamma and t); presorted axes, split by stable partition
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

using std::uint32_t;
using std::vector;

namespace {

/// Shirley, Marschner: Fundamentals of Computer Graphics, section 4.4.2.
bool hitTriangle(const Triangle& triangle, const IntersectionRay& ray, float t0, float t1, float& t)
{
    const float a = -triangle.v1v2.x, b = -triangle.v1v2.y, c = -triangle.v1v2.z;
    const float d = -triangle.v1v3.x, e = -triangle.v1v3.y, f = -triangle.v1v3.z;
    const float g = ray.direction.x, h = ray.direction.y, i = ray.direction.z;
    const float j = triangle.v1.x - ray.origin.x, k = triangle.v1.y - ray.origin.y, l = triangle.v1.z - ray.origin.z;

    const float eihf = e * i - h * f, gfdi = g * f - d * i, dheg = d * h - e * g;
    const float akjb = a * k - j * b, jcal = j * c - a * l, blkc = b * l - k * c;

    const float M = a * eihf + b * gfdi + c * dheg;
    if (M == 0.f)
        return false;
    t = -(f * akjb + e * jcal + d * blkc) / M;
    if (!(t > t0) || !(t < t1))
        return false;
    const float gamma = (i * akjb + h * jcal + g * blkc) / M;
    if (gamma < 0.f || gamma > 1.f)
        return false;
    const float beta = (j * eihf + k * gfdi + l * dheg) / M;
    return !(beta < 0.f || beta > 1.f - gamma);
}

} // namespace

void BVH::construct(const Mesh& mesh)
{
    const uint32_t n = static_cast<uint32_t>(mesh.getFaces().size());
    nodes.clear();
    nodes.push_back(Node{mesh.getBounds(), 0, n});

    // Sorted once along every axis; a split keeps the order in all three lists.
    vector<Point3D> centers(n);
    for (uint32_t f = 0; f < n; ++f) {
        const Triangle triangle = mesh.getTriangleFromFaceIndex(f);
        centers[f] = (triangle.v1 + triangle.v2 + triangle.v3) / 3.f;
    }
    vector<uint32_t> sorted[3];
    for (int axis = 0; axis < 3; ++axis) {
        sorted[axis].resize(n);
        std::iota(sorted[axis].begin(), sorted[axis].end(), 0u);
        std::stable_sort(sorted[axis].begin(), sorted[axis].end(), [&](uint32_t l, uint32_t r) { return centers[l][axis] < centers[r][axis]; });
    }

    vector<bool> goesLeft(n);
    vector<uint32_t> rest;
    for (size_t i = 0; i < nodes.size() && i < (size_t(1) << maxDepth) - 1; ++i) {
        const uint32_t begin = nodes[i].facesBegin, end = nodes[i].facesEnd;
        if (end - begin <= numFacesPerLeaf)
            continue;
        const uint32_t middle = begin + (end - begin) / 2;
        const uint8_t axis = nodes[i].bounds.extents().maxDimension();
        for (uint32_t k = begin; k < end; ++k)
            goesLeft[sorted[axis][k]] = k < middle;
        for (auto& list : sorted) {
            rest.clear();
            uint32_t write = begin;
            for (uint32_t k = begin; k < end; ++k)
                if (goesLeft[list[k]])
                    list[write++] = list[k];
                else
                    rest.push_back(list[k]);
            std::copy(rest.begin(), rest.end(), list.begin() + write);
        }
        if (nodes.size() < 2 * i + 3)
            nodes.resize(2 * i + 3);
        nodes[2 * i + 1] = Node{{}, begin, middle};
        nodes[2 * i + 2] = Node{{}, middle, end};
        for (uint32_t k = begin; k < end; ++k) {
            const Triangle triangle = mesh.getTriangleFromFaceIndex(sorted[axis][k]);
            AABB& bounds = nodes[2 * i + (k < middle ? 1 : 2)].bounds;
            bounds.extend(triangle.v1);
            bounds.extend(triangle.v2);
            bounds.extend(triangle.v3);
        }
    }
    faceIndices = std::move(sorted[0]); // all three hold the same faces in every leaf
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    float closest = ray.t_max;
    int64_t closestFace = -1;

    vector<size_t> stack;
    stack.reserve(BVH::maxDepth + 1);
    if (!nodes.empty())
        stack.push_back(0);
    while (!stack.empty()) {
        const size_t i = stack.back();
        stack.pop_back();
        if (!intersect(nodes[i].bounds, ray))
            continue;
        const size_t child = 2 * i + 1;
        if (child < nodes.size() && nodes[child].facesEnd != 0) {
            stack.push_back(child + 1);
            stack.push_back(child);
            continue;
        }
        for (const uint32_t face : bvh.getFaceIndices(nodes[i])) {
            float t;
            if (hitTriangle(mesh.getTriangleFromFaceIndex(face), ray, ray.t_min, closest, t)) {
                closest = t;
                closestFace = face;
            }
        }
    }

    // point and normal only once, for the winner
    Intersection result;
    if (closestFace >= 0) {
        const Triangle triangle = mesh.getTriangleFromFaceIndex(closestFace);
        result.t = closest;
        result.intersection_point = ray.origin + closest * ray.direction;
        result.normal = cross(triangle.v1v2, triangle.v1v3).normalized();
    }
    return result;
}
