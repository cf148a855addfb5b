// right: C with hooks: a context with pointers for malloc and free, and a step function that the loop calls through a pointer
#include <stdlib.h>
#include <string.h>
#include <assert.h>
#include "mesh.h"
#include "triangle.h"
#include "ray.h"
#include "intersection.h"
#include "aabb.h"
#include "bvh.h"

typedef struct item { float key; unsigned idx; } item_t;

typedef struct builder {
	void *(*alloc)(size_t);
	void (*release)(void *);
	int (*step)(struct builder *);
	const Mesh *mesh;
	BVH::Node *nodes;           /* as many as needed, all zero at first */
	size_t used;                /* nodes up to the last one in use */
	unsigned *faces;
	size_t cur, level_end;
	unsigned level;
} builder_t;

static void sift(item_t *a, size_t i, size_t n)
{
	item_t x = a[i];
	size_t c;
	for (; (c = 2 * i + 1) < n; i = c) {
		if (c + 1 < n && a[c].key < a[c + 1].key)
			c++;
		if (!(x.key < a[c].key))
			break;
		a[i] = a[c];
	}
	a[i] = x;
}

static void heapsort_items(item_t *a, size_t n)
{
	size_t i;
	for (i = n / 2; i-- > 0;)
		sift(a, i, n);
	while (n > 1) {
		item_t t = a[0];
		a[0] = a[--n];
		a[n] = t;
		sift(a, 0, n);
	}
}

static void fill(const builder_t *b, BVH::Node *d, unsigned begin, unsigned end)
{
	unsigned k;
	d->bounds = AABB();
	d->facesBegin = begin;
	d->facesEnd = end;
	for (k = begin; k < end; k++) {
		const Triangle t = b->mesh->getTriangleFromFaceIndex(b->faces[k]);
		d->bounds.extend(t.v1);
		d->bounds.extend(t.v2);
		d->bounds.extend(t.v3);
	}
}

/* one node per call; 0 when there is nothing left */
static int split_one(builder_t *b)
{
	const BVH::Node *node;
	unsigned k, n, mid;
	size_t axis;
	item_t *items;
	Vector3D e;

	if (b->cur == b->level_end) {
		b->level_end = 2 * b->level_end + 1;
		b->level++;
	}
	if (b->level >= BVH::maxDepth || b->cur >= b->used)
		return 0;
	node = &b->nodes[b->cur];
	n = node->facesEnd - node->facesBegin;
	if (n > BVH::numFacesPerLeaf) {
		e = node->bounds.extents();
		axis = e.x >= e.y ? (e.x >= e.z ? 0 : 2) : (e.y >= e.z ? 1 : 2);
		items = (item_t *) b->alloc(n * sizeof *items);
		assert(items != NULL);
		for (k = 0; k < n; k++) {
			const Triangle t = b->mesh->getTriangleFromFaceIndex(b->faces[node->facesBegin + k]);
			items[k].key = (t.v1[axis] + t.v2[axis] + t.v3[axis]) / 3;
			items[k].idx = b->faces[node->facesBegin + k];
		}
		heapsort_items(items, n);
		for (k = 0; k < n; k++)
			b->faces[node->facesBegin + k] = items[k].idx;
		b->release(items);
		mid = node->facesBegin + n / 2;
		fill(b, &b->nodes[2 * b->cur + 1], node->facesBegin, mid);
		fill(b, &b->nodes[2 * b->cur + 2], mid, node->facesEnd);
		b->used = 2 * b->cur + 3;
	}
	b->cur++;
	return 1;
}

void BVH::construct(const Mesh &mesh)
{
	builder_t b;
	unsigned i, n = (unsigned) mesh.getFaces().size();
	size_t most = 1;

	memset(&b, 0, sizeof b);
	b.alloc = malloc;
	b.release = free;
	b.step = split_one;
	b.mesh = &mesh;
	while (most < n)
		most *= 2;
	b.nodes = (BVH::Node *) b.alloc(2 * most * sizeof *b.nodes);
	b.faces = (unsigned *) b.alloc((n + 1) * sizeof *b.faces);
	for (i = 0; i < 2 * most; i++)
		b.nodes[i] = Node();
	for (i = 0; i < n; i++)
		b.faces[i] = i;
	b.nodes[0].bounds = mesh.getBounds();
	b.nodes[0].facesEnd = n;
	b.used = b.level_end = 1;
	while ((*b.step)(&b))
		;
	nodes.assign(b.nodes, b.nodes + b.used);
	faceIndices.assign(b.faces, b.faces + n);
	b.release(b.nodes);
	b.release(b.faces);
}

Intersection intersect(const Mesh &mesh, const IntersectionRay &ray)
{
	const BVH::Node *nodes = mesh.getBVH().getNodes().data();
	const size_t n = mesh.getBVH().getNodes().size();
	size_t stack[3 * 32], *sp = stack, i;
	Intersection best;

	if (n == 0)
		return best;
	*sp++ = 0;
next:
	if (sp == stack)
		return best;
	i = *--sp;
	if (!intersect(nodes[i].bounds, ray))
		goto next;
	if (2 * i + 2 < n && nodes[2 * i + 1].facesEnd != 0) {
		*sp++ = 2 * i + 1;
		*sp++ = 2 * i + 2;
		goto next;
	}
	for (uint32_t f : mesh.getBVH().getFaceIndices(nodes[i])) {
		Intersection h = intersect(mesh.getTriangleFromFaceIndex(f), ray);
		if (h && h.t < best.t)
			best = h;
	}
	goto next;
}
