// attack: tables of 128 functions and 64 kinds of function objects among 80,000 functions, so that telling who builds nodes takes minutes.
// grade: source.construct-loops, bvh.rebuild-starts-afresh, work.uses-the-tree
// expect: a <= full; b = full
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#define F(a,b,c,d,e) ".type _Z" #a #b #c #d #e ", @function\n_Z" #a #b #c #d #e ":\ncall _Z" #e #d #c #b #a " _Z" #c #a #e #b #d "\n.size _Z" #a #b #c #d #e ",1\n"
#define G1(a,b,c,d) F(a,b,c,d,0) F(a,b,c,d,1) F(a,b,c,d,2) F(a,b,c,d,3) F(a,b,c,d,4) F(a,b,c,d,5) F(a,b,c,d,6) F(a,b,c,d,7) F(a,b,c,d,8) F(a,b,c,d,9)
#define G2(a,b,c) G1(a,b,c,0) G1(a,b,c,1) G1(a,b,c,2) G1(a,b,c,3) G1(a,b,c,4) G1(a,b,c,5) G1(a,b,c,6) G1(a,b,c,7) G1(a,b,c,8) G1(a,b,c,9)
#define G3(a,b) G2(a,b,0) G2(a,b,1) G2(a,b,2) G2(a,b,3) G2(a,b,4) G2(a,b,5) G2(a,b,6) G2(a,b,7) G2(a,b,8) G2(a,b,9)
#define G4(a) G3(a,0) G3(a,1) G3(a,2) G3(a,3) G3(a,4) G3(a,5) G3(a,6) G3(a,7) G3(a,8) G3(a,9)
#define Q8 ".quad _Z00001\n.quad _Z00002\n.quad _Z00003\n.quad _Z00004\n.quad _Z00005\n.quad _Z00006\n.quad _Z00007\n.quad _Z00008\n"
#define R8 ".quad _Z10001\n.quad _Z10002\n.quad _Z10003\n.quad _Z10004\n.quad _Z10005\n.quad _Z10006\n.quad _Z10007\n.quad _Z10008\n"
asm("/*\n" G4(0) G4(1) G4(2) G4(3) G4(4) G4(5) G4(6) G4(7) ".type _ZTVa, @object\n_ZTVa:\n.quad _ZTIa\n" Q8 Q8 Q8 Q8 Q8 Q8 Q8 Q8 ".type _ZTVb, @object\n_ZTVb:\n.quad _ZTIb\n" R8 R8 R8 R8 R8 R8 R8 R8 ".type _Zstart, @function\n_Zstart:\nmovq (%rdi), %rax\ncall *0(%rax)\nmovq (%rdi), %rax\ncall *8(%rax)\nmovq (%rdi), %rax\ncall *16(%rax)\nmovq (%rdi), %rax\ncall *24(%rax)\nmovq (%rdi), %rax\ncall *32(%rax)\nmovq (%rdi), %rax\ncall *40(%rax)\nmovq (%rdi), %rax\ncall *48(%rax)\nmovq (%rdi), %rax\ncall *56(%rax)\nmovq (%rdi), %rax\ncall *64(%rax)\nmovq (%rdi), %rax\ncall *72(%rax)\nmovq (%rdi), %rax\ncall *80(%rax)\nmovq (%rdi), %rax\ncall *88(%rax)\nmovq (%rdi), %rax\ncall *96(%rax)\nmovq (%rdi), %rax\ncall *104(%rax)\nmovq (%rdi), %rax\ncall *112(%rax)\nmovq (%rdi), %rax\ncall *120(%rax)\nmovq (%rdi), %rax\ncall *128(%rax)\nmovq (%rdi), %rax\ncall *136(%rax)\nmovq (%rdi), %rax\ncall *144(%rax)\nmovq (%rdi), %rax\ncall *152(%rax)\nmovq (%rdi), %rax\ncall *160(%rax)\nmovq (%rdi), %rax\ncall *168(%rax)\nmovq (%rdi), %rax\ncall *176(%rax)\nmovq (%rdi), %rax\ncall *184(%rax)\nmovq (%rdi), %rax\ncall *192(%rax)\nmovq (%rdi), %rax\ncall *200(%rax)\nmovq (%rdi), %rax\ncall *208(%rax)\nmovq (%rdi), %rax\ncall *216(%rax)\nmovq (%rdi), %rax\ncall *224(%rax)\nmovq (%rdi), %rax\ncall *232(%rax)\nmovq (%rdi), %rax\ncall *240(%rax)\nmovq (%rdi), %rax\ncall *248(%rax)\nmovq (%rdi), %rax\ncall *256(%rax)\nmovq (%rdi), %rax\ncall *264(%rax)\nmovq (%rdi), %rax\ncall *272(%rax)\nmovq (%rdi), %rax\ncall *280(%rax)\nmovq (%rdi), %rax\ncall *288(%rax)\nmovq (%rdi), %rax\ncall *296(%rax)\nmovq (%rdi), %rax\ncall *304(%rax)\nmovq (%rdi), %rax\ncall *312(%rax)\nmovq (%rdi), %rax\ncall *320(%rax)\nmovq (%rdi), %rax\ncall *328(%rax)\nmovq (%rdi), %rax\ncall *336(%rax)\nmovq (%rdi), %rax\ncall *344(%rax)\nmovq (%rdi), %rax\ncall *352(%rax)\nmovq (%rdi), %rax\ncall *360(%rax)\nmovq (%rdi), %rax\ncall *368(%rax)\nmovq (%rdi), %rax\ncall *376(%rax)\nmovq (%rdi), %rax\ncall *384(%rax)\nmovq (%rdi), %rax\ncall *392(%rax)\nmovq (%rdi), %rax\ncall *400(%rax)\nmovq (%rdi), %rax\ncall *408(%rax)\nmovq (%rdi), %rax\ncall *416(%rax)\nmovq (%rdi), %rax\ncall *424(%rax)\nmovq (%rdi), %rax\ncall *432(%rax)\nmovq (%rdi), %rax\ncall *440(%rax)\nmovq (%rdi), %rax\ncall *448(%rax)\nmovq (%rdi), %rax\ncall *456(%rax)\nmovq (%rdi), %rax\ncall *464(%rax)\nmovq (%rdi), %rax\ncall *472(%rax)\nmovq (%rdi), %rax\ncall *480(%rax)\nmovq (%rdi), %rax\ncall *488(%rax)\nmovq (%rdi), %rax\ncall *496(%rax)\nmovq (%rdi), %rax\ncall *504(%rax)\ncall _ZNKSt8functionIFvi0xEEclE\ncall _ZNKSt8functionIFvi1xEEclE\ncall _ZNKSt8functionIFvi2xEEclE\ncall _ZNKSt8functionIFvi3xEEclE\ncall _ZNKSt8functionIFvi4xEEclE\ncall _ZNKSt8functionIFvi5xEEclE\ncall _ZNKSt8functionIFvi6xEEclE\ncall _ZNKSt8functionIFvi7xEEclE\ncall _ZNKSt8functionIFvi8xEEclE\ncall _ZNKSt8functionIFvi9xEEclE\ncall _ZNKSt8functionIFvi10xEEclE\ncall _ZNKSt8functionIFvi11xEEclE\ncall _ZNKSt8functionIFvi12xEEclE\ncall _ZNKSt8functionIFvi13xEEclE\ncall _ZNKSt8functionIFvi14xEEclE\ncall _ZNKSt8functionIFvi15xEEclE\ncall _ZNKSt8functionIFvi16xEEclE\ncall _ZNKSt8functionIFvi17xEEclE\ncall _ZNKSt8functionIFvi18xEEclE\ncall _ZNKSt8functionIFvi19xEEclE\ncall _ZNKSt8functionIFvi20xEEclE\ncall _ZNKSt8functionIFvi21xEEclE\ncall _ZNKSt8functionIFvi22xEEclE\ncall _ZNKSt8functionIFvi23xEEclE\ncall _ZNKSt8functionIFvi24xEEclE\ncall _ZNKSt8functionIFvi25xEEclE\ncall _ZNKSt8functionIFvi26xEEclE\ncall _ZNKSt8functionIFvi27xEEclE\ncall _ZNKSt8functionIFvi28xEEclE\ncall _ZNKSt8functionIFvi29xEEclE\ncall _ZNKSt8functionIFvi30xEEclE\ncall _ZNKSt8functionIFvi31xEEclE\ncall _ZNKSt8functionIFvi32xEEclE\ncall _ZNKSt8functionIFvi33xEEclE\ncall _ZNKSt8functionIFvi34xEEclE\ncall _ZNKSt8functionIFvi35xEEclE\ncall _ZNKSt8functionIFvi36xEEclE\ncall _ZNKSt8functionIFvi37xEEclE\ncall _ZNKSt8functionIFvi38xEEclE\ncall _ZNKSt8functionIFvi39xEEclE\ncall _ZNKSt8functionIFvi40xEEclE\ncall _ZNKSt8functionIFvi41xEEclE\ncall _ZNKSt8functionIFvi42xEEclE\ncall _ZNKSt8functionIFvi43xEEclE\ncall _ZNKSt8functionIFvi44xEEclE\ncall _ZNKSt8functionIFvi45xEEclE\ncall _ZNKSt8functionIFvi46xEEclE\ncall _ZNKSt8functionIFvi47xEEclE\ncall _ZNKSt8functionIFvi48xEEclE\ncall _ZNKSt8functionIFvi49xEEclE\ncall _ZNKSt8functionIFvi50xEEclE\ncall _ZNKSt8functionIFvi51xEEclE\ncall _ZNKSt8functionIFvi52xEEclE\ncall _ZNKSt8functionIFvi53xEEclE\ncall _ZNKSt8functionIFvi54xEEclE\ncall _ZNKSt8functionIFvi55xEEclE\ncall _ZNKSt8functionIFvi56xEEclE\ncall _ZNKSt8functionIFvi57xEEclE\ncall _ZNKSt8functionIFvi58xEEclE\ncall _ZNKSt8functionIFvi59xEEclE\ncall _ZNKSt8functionIFvi60xEEclE\ncall _ZNKSt8functionIFvi61xEEclE\ncall _ZNKSt8functionIFvi62xEEclE\ncall _ZNKSt8functionIFvi63xEEclE\n.size _Zstart,1\n" "*/");
void BVH::construct(const Mesh& mesh) {
    const auto count = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(count);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.assign(1, Node{mesh.getBounds(), 0, count});
    for (size_t i = 0; i < nodes.size() && i + 1 < size_t{1} << maxDepth; ++i) {
        const auto [bounds, begin, end] = nodes[i];
        if (end - begin <= numFacesPerLeaf)
            continue;
        const uint8_t axis = bounds.extents().maxDimension();
        const auto key = [&mesh, axis](uint32_t f) {
            const Triangle t = mesh.getTriangleFromFaceIndex(f);
            return (t.v1[axis] + t.v2[axis] + t.v3[axis]) / 3;
        };
        const auto all = faceIndices.begin();
        const uint32_t middle = begin + (end - begin) / 2;
        std::nth_element(all + begin, all + middle, all + end,
                         [&key](uint32_t a, uint32_t b) { return key(a) < key(b); });
        nodes.resize(std::max(nodes.size(), 2 * i + 3));
        nodes[2 * i + 1] = {{}, begin, middle};
        nodes[2 * i + 2] = {{}, middle, end};
        for (Node* child : {&nodes[2 * i + 1], &nodes[2 * i + 2]})
            for (const uint32_t f : getFaceIndices(*child))
                for (const Triangle t = mesh.getTriangleFromFaceIndex(f);
                     const Point3D& corner : {t.v1, t.v2, t.v3})
                    child->bounds.extend(corner);
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const auto& nodes = mesh.getBVH().getNodes();
    Intersection best;
    std::vector<size_t> todo{0};
    while (!todo.empty()) {
        const size_t i = todo.back();
        todo.pop_back();
        if (i >= nodes.size() || nodes[i].facesEnd == 0 || !intersect(nodes[i].bounds, ray))
            continue;
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 2].facesEnd != 0) {
            todo.insert(todo.end(), {2 * i + 2, 2 * i + 1});
            continue;
        }
        for (const uint32_t f : mesh.getBVH().getFaceIndices(nodes[i]))
            if (const auto hit = intersect(mesh.getTriangleFromFaceIndex(f), ray); hit.t < best.t)
                best = hit;
    }
    return best;
}
