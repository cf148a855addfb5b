#include "not_written.h"

#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

// Weak, so that the submission's own definitions win. A submission that defines only one of the
// two functions still links, and the part that it does define is graded.

__attribute__((weak)) void BVH::construct(const Mesh& /*mesh*/) {
    throw ex03::NotWritten();
}

__attribute__((weak)) Intersection intersect(const Mesh& /*mesh*/, const IntersectionRay& /*ray*/) {
    throw ex03::NotWritten();
}
