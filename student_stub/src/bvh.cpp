#include "bvh.h"

std::span<const uint32_t> BVH::getFaceIndices(const Node& node) const {
    return std::span(faceIndices).subspan(node.facesBegin, node.facesEnd - node.facesBegin);
}

std::span<uint32_t> BVH::getFaceIndices(const Node& node) {
    return std::span(faceIndices).subspan(node.facesBegin, node.facesEnd - node.facesBegin);
}
