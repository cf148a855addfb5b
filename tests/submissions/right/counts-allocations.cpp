// right: global operator new and delete are replaced to count allocations; strings and streams in construct
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include <atomic>
#include <cstdlib>
#include <map>
#include <memory>
#include <new>
#include <sstream>
#include <string>

static std::atomic<size_t> g_allocations{0}, g_bytes{0};

void* operator new(std::size_t size)
{
    ++g_allocations;
    g_bytes += size;
    if (void* p = std::malloc(size ? size : 1))
        return p;
    throw std::bad_alloc();
}
void* operator new[](std::size_t size) { return ::operator new(size); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }

std::ostream& operator<<(std::ostream& out, const Point3D& p) { return out << '(' << p.x << ", " << p.y << ", " << p.z << ')'; }
std::ostream& operator<<(std::ostream& out, const AABB& b) { return out << b.min << " - " << b.max; }
std::ostream& operator<<(std::ostream& out, const BVH::Node& n) { return out << n.bounds << " [" << n.facesBegin << ", " << n.facesEnd << ')'; }

void BVH::construct(const Mesh& mesh)
{
    const size_t before = g_allocations;
    const auto numFaces = uint32_t(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);
    std::vector<Point3D> centers(numFaces);
    for (uint32_t f = 0; f < numFaces; ++f) {
        const Triangle t = mesh.getTriangleFromFaceIndex(f);
        centers[f] = (t.v1 + t.v2 + t.v3) / 3;
    }
    std::map<uint32_t, Node> tree{{0, Node{mesh.getBounds(), 0, numFaces}}};
    for (auto it = tree.begin(); it != tree.end(); ++it) { // children come later in the map
        const uint32_t i = it->first;
        const Node& node = it->second;
        const uint32_t count = node.facesEnd - node.facesBegin;
        if (count <= numFacesPerLeaf || std::bit_width(i + 1) > maxDepth)
            continue;
        const auto axis = node.bounds.extents().maxDimension();
        auto part = getFaceIndices(node);
        std::nth_element(part.begin(), part.begin() + count / 2, part.end(),
                         [&](uint32_t a, uint32_t b) { return centers[a][axis] < centers[b][axis]; });
        for (uint32_t right = 0; right < 2; ++right) {
            Node child;
            child.facesBegin = node.facesBegin + (right ? count / 2 : 0);
            child.facesEnd = right ? node.facesEnd : node.facesBegin + count / 2;
            for (uint32_t f : getFaceIndices(child)) {
                const Triangle t = mesh.getTriangleFromFaceIndex(f);
                child.bounds.extend(t.v1);
                child.bounds.extend(t.v2);
                child.bounds.extend(t.v3);
            }
            tree.emplace(2 * i + 1 + right, child);
        }
    }
    nodes.assign(tree.rbegin()->first + 1, Node{});
    for (const auto& [i, node] : tree)
        nodes[i] = node;

    std::ostringstream out;
    out << "root: " << nodes.front() << ", a rather long line so that the string has to grow on the heap\n";
    std::string text = out.str();
    text += std::to_string(g_allocations - before) + " allocations, " + std::to_string(g_bytes) + " bytes in all";
    std::getline(std::istringstream(text), text);
    std::cout << text << std::endl;
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    const BVH& bvh = mesh.getBVH();
    Intersection best;
    auto stack = std::make_unique<std::vector<size_t>>();
    if (bvh.isConstructed())
        stack->emplace_back(0);
    while (!stack->empty()) {
        const size_t i = stack->back();
        stack->pop_back();
        const auto& node = bvh.getNodes()[i];
        if (!intersect(node.bounds, ray))
            continue;
        if (2 * i + 2 < bvh.getNodes().size() && bvh.getNodes()[2 * i + 1].facesEnd) {
            stack->push_back(2 * i + 1);
            stack->push_back(2 * i + 2);
        } else
            for (auto f : bvh.getFaceIndices(node)) {
                const auto hit = intersect(mesh.getTriangleFromFaceIndex(f), ray);
                if (hit.t < best.t)
                    best = hit;
            }
    }
    return best;
}
