// right: the watertight ray/triangle test of Woop, Benthin and Wald with its own shear, in place of the given one; const copy of the ray data
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include "ray.h"

namespace {

// S. Woop, C. Benthin, I. Wald: Watertight Ray/Triangle Intersection, JCGT 2(1), 2013.
class ShearedRay {
public:
    explicit ShearedRay(const IntersectionRay& ray) : ray(ray)
    {
        const Vector3D size{std::fabs(ray.direction.x), std::fabs(ray.direction.y), std::fabs(ray.direction.z)};
        kz = size.maxDimension();
        kx = (kz + 1) % 3;
        ky = (kx + 1) % 3;
        if (ray.direction[kz] < 0.f)
            std::swap(kx, ky); // keeps the winding
        sx = ray.direction[kx] / ray.direction[kz];
        sy = ray.direction[ky] / ray.direction[kz];
        sz = 1.f / ray.direction[kz];
    }

    Intersection meet(const Triangle& triangle, float tMax) const
    {
        const Vector3D a = triangle.v1 - ray.origin, b = triangle.v2 - ray.origin, c = triangle.v3 - ray.origin;
        const float ax = a[kx] - sx * a[kz], ay = a[ky] - sy * a[kz];
        const float bx = b[kx] - sx * b[kz], by = b[ky] - sy * b[kz];
        const float cx = c[kx] - sx * c[kz], cy = c[ky] - sy * c[kz];
        float u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
        if (u == 0.f || v == 0.f || w == 0.f) { // on an edge: decide in double
            u = static_cast<float>(double(cx) * by - double(cy) * bx);
            v = static_cast<float>(double(ax) * cy - double(ay) * cx);
            w = static_cast<float>(double(bx) * ay - double(by) * ax);
        }
        if ((u < 0.f || v < 0.f || w < 0.f) && (u > 0.f || v > 0.f || w > 0.f))
            return {};
        const float det = u + v + w;
        if (det == 0.f)
            return {};
        const float t = (u * sz * a[kz] + v * sz * b[kz] + w * sz * c[kz]) / det;
        if (!(t > ray.t_min && t < tMax))
            return {};
        const Vector3D normal = cross(triangle.v1v2, triangle.v1v3);
        const float length = normal.norm();
        if (!(length > 0.f))
            return {};
        return {ray.origin + ray.direction * t, t, normal / length};
    }

private:
    const IntersectionRay& ray;
    uint8_t kx, ky, kz;
    float sx, sy, sz;
};

} // namespace

void BVH::construct(const Mesh& mesh)
{
    const uint32_t n = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(n);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);
    std::vector<Node> tree{Node{mesh.getBounds(), 0, n}}; // becomes the member at the very end

    std::queue<std::pair<uint32_t, uint32_t>> levels; // node and its level
    levels.emplace(0, 0);
    while (!levels.empty()) {
        const auto [index, level] = levels.front();
        levels.pop();
        const Node parent = tree[index];
        if (parent.facesEnd <= parent.facesBegin + numFacesPerLeaf || level == maxDepth)
            continue;
        const auto axis = parent.bounds.extents().maxDimension();
        const auto first = faceIndices.begin() + parent.facesBegin;
        const auto last = faceIndices.begin() + parent.facesEnd;
        const auto middle = first + (last - first) / 2;
        std::nth_element(first, middle, last, [axis, &mesh](uint32_t l, uint32_t r) {
            const Triangle a = mesh.getTriangleFromFaceIndex(l), b = mesh.getTriangleFromFaceIndex(r);
            return double(a.v1[axis]) + a.v2[axis] + a.v3[axis] < double(b.v1[axis]) + b.v2[axis] + b.v3[axis];
        });
        std::array<Node, 2> children;
        children[0].facesBegin = parent.facesBegin;
        children[0].facesEnd = children[1].facesBegin = static_cast<uint32_t>(middle - faceIndices.begin());
        children[1].facesEnd = parent.facesEnd;
        for (uint32_t side : {0u, 1u}) {
            for (uint32_t face : getFaceIndices(children[side])) {
                const TriangleIndices& corners = mesh.getFaces()[face];
                children[side].bounds.extend(mesh.getVertices()[corners.v1]);
                children[side].bounds.extend(mesh.getVertices()[corners.v2]);
                children[side].bounds.extend(mesh.getVertices()[corners.v3]);
            }
            const uint32_t child = 2 * index + 1 + side;
            if (tree.size() <= child)
                tree.resize(child + 1);
            tree[child] = children[side];
            levels.emplace(child, level + 1);
        }
    }
    nodes = std::move(tree);
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    const ShearedRay sheared(ray);
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    Intersection closest;
    std::stack<uint32_t, std::vector<uint32_t>> open;
    if (!nodes.empty())
        open.push(0);
    while (!open.empty()) {
        const uint32_t index = open.top();
        open.pop();
        if (!intersect(nodes[index].bounds, ray))
            continue;
        const uint32_t left = 2 * index + 1;
        if (left >= nodes.size() || nodes[left].facesEnd == 0) {
            for (uint32_t face : bvh.getFaceIndices(nodes[index]))
                if (const auto hit = sheared.meet(mesh.getTriangleFromFaceIndex(face), std::min(ray.t_max, closest.t)))
                    closest = hit;
            continue;
        }
        open.push(left + 1);
        open.push(left);
    }
    return closest;
}
