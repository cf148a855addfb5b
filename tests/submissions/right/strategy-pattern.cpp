// right: object-oriented: abstract strategies for axis and split behind unique_ptr, an abstract visitor for the traversal
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <memory>

namespace {

class AxisStrategy {
public:
    virtual ~AxisStrategy() = default;
    virtual uint8_t choose(const BVH::Node& node) const = 0;
};

class LongestAxis final : public AxisStrategy {
public:
    uint8_t choose(const BVH::Node& node) const override { return node.bounds.extents().maxDimension(); }
};

class SplitStrategy {
public:
    virtual ~SplitStrategy() = default;
    /// Reorders the faces of the node and returns how many of them go to the left.
    virtual uint32_t split(const BVH::Node& node, std::span<uint32_t> faces) const = 0;
};

class MedianSplit final : public SplitStrategy {
public:
    MedianSplit(const Mesh& mesh, std::unique_ptr<AxisStrategy> axisStrategy)
        : mesh(mesh), axisStrategy(std::move(axisStrategy)) {}

    uint32_t split(const BVH::Node& node, std::span<uint32_t> faces) const override
    {
        const uint8_t axis = axisStrategy->choose(node);
        const auto middle = faces.begin() + faces.size() / 2;
        std::nth_element(faces.begin(), middle, faces.end(), [&](uint32_t a, uint32_t b) {
            return center(a, axis) < center(b, axis);
        });
        return static_cast<uint32_t>(middle - faces.begin());
    }

private:
    float center(uint32_t face, uint8_t axis) const
    {
        const Triangle t = mesh.getTriangleFromFaceIndex(face);
        return (t.v1[axis] + t.v2[axis] + t.v3[axis]) / 3.0f;
    }

    const Mesh& mesh;
    std::unique_ptr<AxisStrategy> axisStrategy;
};

class NodeFactory {
public:
    explicit NodeFactory(const Mesh& mesh) : mesh(mesh) {}
    virtual ~NodeFactory() = default;
    virtual BVH::Node create(uint32_t begin, std::span<const uint32_t> faces) const
    {
        BVH::Node node;
        node.facesBegin = begin;
        node.facesEnd = begin + static_cast<uint32_t>(faces.size());
        for (uint32_t face : faces) {
            const Triangle t = mesh.getTriangleFromFaceIndex(face);
            node.bounds.extend(t.v1);
            node.bounds.extend(t.v2);
            node.bounds.extend(t.v3);
        }
        return node;
    }

private:
    const Mesh& mesh;
};

class LeafVisitor {
public:
    virtual ~LeafVisitor() = default;
    virtual bool enters(const AABB& box) = 0;
    virtual void visit(uint32_t face) = 0;
};

class ClosestHit final : public LeafVisitor {
public:
    ClosestHit(const Mesh& mesh, const IntersectionRay& ray) : mesh(mesh), ray(ray) {}

    bool enters(const AABB& box) override { return intersect(box, ray); }

    void visit(uint32_t face) override
    {
        const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
        if (hit.t < closest.t)
            closest = hit;
    }

    Intersection result() const { return closest; }

private:
    const Mesh& mesh;
    const IntersectionRay& ray;
    Intersection closest;
};

void accept(const BVH& bvh, LeafVisitor& visitor)
{
    const auto& nodes = bvh.getNodes();
    std::vector<size_t> open;
    if (!nodes.empty())
        open.push_back(0);
    while (!open.empty()) {
        const size_t node = open.back();
        open.pop_back();
        if (!visitor.enters(nodes[node].bounds))
            continue;
        const size_t left = 2 * node + 1;
        if (left + 1 < nodes.size() && nodes[left].facesEnd != 0) {
            open.push_back(left + 1);
            open.push_back(left);
        } else {
            for (uint32_t face : bvh.getFaceIndices(nodes[node]))
                visitor.visit(face);
        }
    }
}

} // namespace

void BVH::construct(const Mesh& mesh)
{
    const std::unique_ptr<SplitStrategy> strategy = std::make_unique<MedianSplit>(mesh, std::make_unique<LongestAxis>());
    const std::unique_ptr<NodeFactory> factory = std::make_unique<NodeFactory>(mesh);

    faceIndices.resize(mesh.getFaces().size());
    std::iota(faceIndices.begin(), faceIndices.end(), 0);
    nodes.clear();
    nodes.push_back(Node{mesh.getBounds(), 0, static_cast<uint32_t>(faceIndices.size())});

    for (size_t i = 0; i < nodes.size(); ++i) {
        const Node node = nodes[i];
        const bool tooDeep = std::bit_width(i + 1) > maxDepth;
        if (node.facesEnd - node.facesBegin <= numFacesPerLeaf || tooDeep)
            continue;
        const std::span<uint32_t> faces = getFaceIndices(node);
        const uint32_t numLeft = strategy->split(node, faces);
        if (nodes.size() < 2 * i + 3)
            nodes.resize(2 * i + 3);
        nodes[2 * i + 1] = factory->create(node.facesBegin, faces.first(numLeft));
        nodes[2 * i + 2] = factory->create(node.facesBegin + numLeft, faces.subspan(numLeft));
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    ClosestHit visitor(mesh, ray);
    accept(mesh.getBVH(), visitor);
    return visitor.result();
}
