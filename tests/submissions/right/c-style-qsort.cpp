// right: C as in 1989: qsort with file-scope variables, malloc and free, goto, alternative tokens, declarations at the top
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <stdlib.h>
#include <string.h>
#include <stdio.h>

#define LONGEST(e) ((e).x >= (e).y and (e).x >= (e).z ? 0 : (e).y >= (e).z ? 1 : 2)

typedef struct { float center; unsigned int face; } entry_t;

/* qsort knows no context */
static const Mesh *the_mesh;
static unsigned long comparisons;

static int compare(const void *a, const void *b)
{
    const entry_t *l = (const entry_t *)a, *r = (const entry_t *)b;
    ++comparisons;
    if (l->center < r->center) return -1;
    if (l->center > r->center) return 1;
    return 0;
}

static void grow(AABB *box, unsigned int face)
{
    const TriangleIndices *f = &the_mesh->getFaces()[face];
    const unsigned int v<:3:> = <% f->v1, f->v2, f->v3 %>;
    int k;
    for (k = 0; k not_eq 3; k++)
        box->extend(the_mesh->getVertices()[v[k]]);
}

void BVH::construct(const Mesh &mesh)
{
    unsigned int i, k, n, begin, end, mid, axis, level_end, depth;
    entry_t *entries;

    the_mesh = &mesh;
    comparisons = 0;
    n = (unsigned int)mesh.getFaces().size();
    entries = (entry_t *)malloc((n + 1) * sizeof(entry_t));
    if (not entries) abort();
    faceIndices.resize(n);
    for (i = 0; i < n; i++) faceIndices[i] = i;
    nodes.clear();
    nodes.resize(1);
    nodes[0].bounds = mesh.getBounds();
    nodes[0].facesEnd = n;

    i = 0, depth = 0, level_end = 0;
again:
    if (i >= nodes.size() or depth == maxDepth) goto done;
    begin = nodes[i].facesBegin, end = nodes[i].facesEnd;
    if (end - begin > numFacesPerLeaf) {
        axis = LONGEST(nodes[i].bounds.extents());
        for (k = begin; k < end; k++) {
            const Triangle t = mesh.getTriangleFromFaceIndex(faceIndices[k]);
            entries[k].center = (t.v1[axis] + t.v2[axis] + t.v3[axis]) / 3;
            entries[k].face = faceIndices[k];
        }
        qsort(entries + begin, end - begin, sizeof *entries, compare);
        for (k = begin; k < end; k++) faceIndices[k] = entries[k].face;
        mid = begin + ((end - begin) >> 1);
        if (nodes.size() < 2 * i + 3) nodes.resize(2 * i + 3);
        nodes[2 * i + 1].facesBegin = begin;
        nodes[2 * i + 1].facesEnd = mid;
        nodes[2 * i + 2].facesBegin = mid;
        nodes[2 * i + 2].facesEnd = end;
        for (k = begin; k < end; k++) grow(&nodes[k < mid ? 2 * i + 1 : 2 * i + 2].bounds, faceIndices[k]);
    }
    if (i++ == level_end) {
        level_end = 2 * level_end + 2;
        depth++;
    }
    goto again;
done:
    free(entries);
    fprintf(stderr, "%lu comparisons\n", comparisons);
}

Intersection intersect(const Mesh &mesh, const IntersectionRay &ray)
{
    Intersection hit, best;
    const BVH::Node *nodes = mesh.getBVH().getNodes().data();
    const size_t count = mesh.getBVH().getNodes().size();
    size_t stack[8 * sizeof(size_t)], node;
    size_t *sp = stack;

    memset(stack, 0, sizeof stack);
    if (count == 0) goto out;
    *sp++ = 0;
    while (sp not_eq stack) {
        node = *--sp;
        if (!intersect(nodes[node].bounds, ray)) continue;
        if (2 * node + 1 >= count or nodes[2 * node + 1].facesEnd == 0) {
            for (uint32_t face : mesh.getBVH().getFaceIndices(nodes[node])) {
                hit = intersect(mesh.getTriangleFromFaceIndex(face), ray);
                if (hit.t < best.t) best = hit;
            }
        } else {
            *sp++ = 2 * node + 1;
            *sp++ = 2 * node + 2;
        }
    }
out:
    return best;
}
