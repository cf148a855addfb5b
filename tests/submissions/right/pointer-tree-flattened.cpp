// right: a tree of unique_ptrs is grown in a loop and then written into the vector of nodes; intersect carries node, depth and entry in a struct
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <memory>

namespace tree
{
    struct Node
    {
        std::vector<uint32_t> faces;
        AABB box;
        std::unique_ptr<Node> left, right;

        Node(std::vector<uint32_t> f, const Mesh& mesh) : faces(std::move(f))
        {
            for (uint32_t face : faces)
            {
                const Triangle t = mesh.getTriangleFromFaceIndex(face);
                for (const Point3D& p : {t.v1, t.v2, t.v3})
                    box.extend(p);
            }
        }

        // splits this node only; its children are split by whoever calls
        void split(const Mesh& mesh)
        {
            const auto axis = box.extents().maxDimension();
            std::vector<std::pair<float, uint32_t>> sorted;
            for (uint32_t face : faces)
            {
                const Triangle t = mesh.getTriangleFromFaceIndex(face);
                sorted.emplace_back((t.v1[axis] + t.v2[axis] + t.v3[axis]) / 3.f, face);
            }
            std::sort(sorted.begin(), sorted.end());
            std::vector<uint32_t> halves[2];
            for (size_t k = 0; k < sorted.size(); ++k)
                halves[k >= sorted.size() / 2].push_back(sorted[k].second);
            left = std::make_unique<Node>(std::move(halves[0]), mesh);
            right = std::make_unique<Node>(std::move(halves[1]), mesh);
        }
    };
}

void BVH::construct(const Mesh& mesh)
{
    nodes.clear();
    faceIndices.clear();
    if (mesh.getFaces().empty())
        return;

    std::vector<uint32_t> all(mesh.getFaces().size());
    std::iota(all.begin(), all.end(), 0u);
    auto root = std::make_unique<tree::Node>(std::move(all), mesh);
    root->box = mesh.getBounds();

    std::stack<std::pair<tree::Node*, uint32_t>> unsplit;
    unsplit.push({root.get(), 0});
    while (!unsplit.empty())
    {
        auto [node, depth] = unsplit.top();
        unsplit.pop();
        if (node->faces.size() <= numFacesPerLeaf || depth == maxDepth)
            continue;
        node->split(mesh);
        std::vector<uint32_t>().swap(node->faces); // the children have them now
        unsplit.push({node->left.get(), depth + 1});
        unsplit.push({node->right.get(), depth + 1});
    }

    // leaves from left to right give the face indices
    struct Visit { const tree::Node* node; size_t index; bool done; };
    std::stack<Visit> visits;
    visits.push({root.get(), 0, false});
    while (!visits.empty())
    {
        const Visit visit = visits.top();
        visits.pop();
        if (nodes.size() <= visit.index)
            nodes.resize(visit.index + 1);
        if (visit.done)
        {
            nodes[visit.index].facesEnd = static_cast<uint32_t>(faceIndices.size());
            continue;
        }
        nodes[visit.index].bounds = visit.node->box;
        nodes[visit.index].facesBegin = static_cast<uint32_t>(faceIndices.size());
        faceIndices.insert(faceIndices.end(), visit.node->faces.begin(), visit.node->faces.end());
        visits.push({visit.node, visit.index, true});
        if (visit.node->left)
        {
            visits.push({visit.node->right.get(), 2 * visit.index + 2, false});
            visits.push({visit.node->left.get(), 2 * visit.index + 1, false});
        }
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    struct Step { size_t node; int depth; };
    const BVH& bvh = mesh.getBVH();
    const auto& nodes = bvh.getNodes();
    Intersection closest;
    std::deque<Step> steps;
    if (bvh.isConstructed())
        steps.push_front({0, 0});
    while (!steps.empty())
    {
        const auto [node, depth] = steps.front();
        steps.pop_front();
        if (!intersect(nodes[node].bounds, ray))
            continue;
        const size_t left = 2 * node + 1;
        if (depth < int(BVH::maxDepth) && left < nodes.size() && nodes[left].facesEnd > nodes[left].facesBegin)
        {
            steps.push_front({left + 1, depth + 1});
            steps.push_front({left, depth + 1});
            continue;
        }
        for (const uint32_t face : bvh.getFaceIndices(nodes[node]))
        {
            const auto hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
            if (hit.t < closest.t)
                closest = hit;
        }
    }
    return closest;
}
