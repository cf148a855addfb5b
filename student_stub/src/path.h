#pragma once

#include "intersection.h"
#include "mesh.h"

namespace ex03 {

/// One call of a given test, as `exercise03_abi.h` lays it out.
struct Step {
    uint32_t kind;
    uint32_t hit;
    uint32_t node;
    float t;
    std::array<float, 2> limits;
    std::array<float, 9> corners;
};

/// What one ray tests, in order.
struct Path {
    const Mesh* mesh;
    Step* steps;
    uint64_t capacity;
    uint64_t count{0};

    void add(const AABB& box, const Ray& ray, bool hit);
    void add(const Triangle& triangle, const Ray& ray, const Intersection& found);

  private:
    Step* next(const Ray& ray);
};

/// Of the current thread; null unless somebody asks for the path of a ray.
extern constinit thread_local Path* path;

} // namespace ex03
