#include "path.h"

#include "exercise03_abi.h"

#include <type_traits>

static_assert(sizeof(ex03::Step) == 60 && std::is_trivially_copyable_v<ex03::Step>);

namespace ex03 {

constinit thread_local Path* path = nullptr;

namespace {

/// Index of the node that holds this very box; `EX03_NO_NODE` for a copy.
uint32_t nodeOf(const AABB& box, const Mesh& mesh) {
    const std::vector<BVH::Node>& nodes = mesh.getBVH().getNodes();
    const auto first = reinterpret_cast<uintptr_t>(nodes.data());
    const auto place = reinterpret_cast<uintptr_t>(&box) - first;
    const bool inside = place < nodes.size() * sizeof(BVH::Node) && place % sizeof(BVH::Node) == 0;
    return inside ? static_cast<uint32_t>(place / sizeof(BVH::Node)) : EX03_NO_NODE;
}

void copy(const Point3D& point, float* out) {
    out[0] = point.x;
    out[1] = point.y;
    out[2] = point.z;
}

} // namespace

Step* Path::next(const Ray& ray) {
    if (count++ >= capacity) {
        return nullptr;
    }
    Step* step = steps + (count - 1);
    *step = {};
    step->limits[0] = ray.t_min;
    step->limits[1] = ray.t_max;
    return step;
}

void Path::add(const AABB& box, const Ray& ray, bool hit) {
    if (Step* step = next(ray)) {
        step->kind = EX03_BOX_TEST;
        step->hit = hit ? 1 : 0;
        step->node = nodeOf(box, *mesh);
        copy(box.min, step->corners.data());
        copy(box.max, step->corners.data() + 3);
    }
}

void Path::add(const Triangle& triangle, const Ray& ray, const Intersection& found) {
    if (Step* step = next(ray)) {
        step->kind = EX03_TRIANGLE_TEST;
        step->hit = found ? 1 : 0;
        step->node = EX03_NO_NODE;
        step->t = found.t;
        copy(triangle.v1, step->corners.data());
        copy(triangle.v2, step->corners.data() + 3);
        copy(triangle.v3, step->corners.data() + 6);
    }
}

} // namespace ex03
