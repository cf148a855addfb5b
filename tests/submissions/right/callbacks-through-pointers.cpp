// right: C callbacks: one loop for nodes and for faces, told by function pointers what to do, so the callback of one starts the other
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

typedef void (*callback_t)(void* context, uint32_t index);

/* Calls `callback` for begin, begin + 1, ... end - 1. */
static void forEach(uint32_t begin, uint32_t end, callback_t callback, void* context)
{
    for (uint32_t i = begin; i < end; i++)
        callback(context, i);
}

struct Builder
{
    const Mesh* mesh;
    std::vector<BVH::Node>* nodes;
    std::vector<uint32_t>* faceIndices;
    uint32_t child; /* whose box is being made */
    bool split;     /* was there anything to do on this level? */
};

static float triangleCenter(const Builder& builder, uint32_t face, uint8_t axis)
{
    const Triangle t = builder.mesh->getTriangleFromFaceIndex(face);
    return (t.v1[axis] + t.v2[axis] + t.v3[axis]) / 3.0f;
}

static void extendBox(void* context, uint32_t k)
{
    Builder& builder = *static_cast<Builder*>(context);
    const Triangle t = builder.mesh->getTriangleFromFaceIndex((*builder.faceIndices)[k]);
    AABB& box = (*builder.nodes)[builder.child].bounds;
    box.extend(t.v1);
    box.extend(t.v2);
    box.extend(t.v3);
}

static void splitNode(void* context, uint32_t i)
{
    Builder& builder = *static_cast<Builder*>(context);
    std::vector<BVH::Node>& nodes = *builder.nodes;
    const uint32_t begin = nodes[i].facesBegin, end = nodes[i].facesEnd;
    if (end - begin <= BVH::numFacesPerLeaf)
        return;
    builder.split = true;
    const uint32_t middle = begin + (end - begin) / 2;
    const uint8_t axis = nodes[i].bounds.extents().maxDimension();
    uint32_t* faces = builder.faceIndices->data();
    std::nth_element(faces + begin, faces + middle, faces + end, [&](uint32_t a, uint32_t b) {
        return triangleCenter(builder, a, axis) < triangleCenter(builder, b, axis);
    });
    if (nodes.size() < 2 * i + 3)
        nodes.resize(2 * i + 3);
    const uint32_t cut[3] = {begin, middle, end};
    for (uint32_t side = 0; side < 2; side++) {
        builder.child = 2 * i + 1 + side;
        nodes[builder.child] = BVH::Node{AABB{}, cut[side], cut[side + 1]};
        forEach(cut[side], cut[side + 1], extendBox, &builder);
    }
}

void BVH::construct(const Mesh& mesh)
{
    const uint32_t numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);
    nodes.assign(1, Node{mesh.getBounds(), 0, numFaces});

    Builder builder{&mesh, &nodes, &faceIndices, 0, true};
    for (uint32_t level = 0; level < maxDepth && builder.split; level++) {
        builder.split = false;
        const uint32_t first = (1u << level) - 1;
        const uint32_t last = std::min<uint32_t>(2 * first + 1, nodes.size());
        forEach(first, last, splitNode, &builder);
    }
}

struct Search
{
    const Mesh* mesh;
    const IntersectionRay* ray;
    Intersection closest;
};

static void testFace(void* context, uint32_t face)
{
    Search& search = *static_cast<Search*>(context);
    const Intersection hit = intersect(search.mesh->getTriangleFromFaceIndex(face), *search.ray);
    if (hit.t < search.closest.t)
        search.closest = hit;
}

static void walk(const BVH& bvh, uint32_t i, const IntersectionRay& ray, callback_t callback, void* context)
{
    const auto& nodes = bvh.getNodes();
    if (i >= nodes.size() || nodes[i].facesEnd == 0 || !intersect(nodes[i].bounds, ray))
        return;
    if (2 * i + 1 < nodes.size() && nodes[2 * i + 1].facesEnd != 0) {
        walk(bvh, 2 * i + 2, ray, callback, context);
        walk(bvh, 2 * i + 1, ray, callback, context);
        return;
    }
    for (uint32_t face : bvh.getFaceIndices(nodes[i]))
        callback(context, face);
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
    Search search{&mesh, &ray, {}};
    walk(mesh.getBVH(), 0, ray, testFace, &search);
    return search.closest;
}
