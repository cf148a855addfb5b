#pragma once

#include "aabb.h"

class Mesh;

namespace ex03 {
struct Access;
}

/// A bounding volume hierarchy: a full binary tree of boxes over the faces of one mesh.
///
/// The children of node `i` are the nodes `2 * i + 1` and `2 * i + 2`. Node `i` is a leaf if
/// these two lie outside the vector of nodes, or if their `facesEnd` is 0 (an unused slot).
class BVH {
  public:
    /// A node with more faces than this is split ...
    static constexpr uint32_t numFacesPerLeaf{4};

    /// ... unless the tree is already this deep.
#ifdef EX03_MAX_DEPTH
    static constexpr uint32_t maxDepth{EX03_MAX_DEPTH};
#else
    static constexpr uint32_t maxDepth{20};
#endif

    /// The faces `faceIndices[facesBegin]` up to, not including, `faceIndices[facesEnd]`.
    struct Node {
        AABB bounds;
        uint32_t facesBegin{0};
        uint32_t facesEnd{0};
    };

    /// Builds the tree for `mesh`; whatever was in it before is gone. Exercise part a).
    void construct(const Mesh& mesh);

    bool isConstructed() const { return !nodes.empty(); }

    const std::vector<Node>& getNodes() const { return nodes; }

    /// The faces of `node`, as indices into the faces of the mesh.
    std::span<const uint32_t> getFaceIndices(const Node& node) const;

  private:
    friend struct ex03::Access; // lets the grader read a tree, and put one in

    /// The same faces, to be reordered in place.
    std::span<uint32_t> getFaceIndices(const Node& node);

    std::vector<Node> nodes;
    std::vector<uint32_t> faceIndices;
};
