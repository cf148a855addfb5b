#pragma once

#include "mesh.h"

namespace ex03 {

/// The framework's way past `private`: submissions have no reason to use it.
struct Access {
    static BVH& bvh(Mesh& mesh) { return mesh.bvh; }
    static std::vector<BVH::Node>& nodes(BVH& bvh) { return bvh.nodes; }
    static std::vector<uint32_t>& faceIndices(BVH& bvh) { return bvh.faceIndices; }
    static const std::vector<uint32_t>& faceIndices(const BVH& bvh) { return bvh.faceIndices; }
};

} // namespace ex03
