// right: X-macros, digraphs, alternative tokens, #line, CRLF and tabs; rows are kept in a heap of the largest nodes
%:include "bvh.h"
%:include "mesh.h"
#include <list>
%:include "intersection.h"

%:define AXES X(0, x) X(1, y) X(2, z)
#define CORNERS Y(v1) Y(v2) Y(v3)
#define FOREVER for (;;)
#define UNLESS(c) if (not (c))
#line 1000 "bvh_macros.inc"
namespace
<%
	enum axis_t : unsigned char
	<%
%:define X(n, c) AXIS_##c = n,
	AXES
#undef X
	%>;

	axis_t longest(const AABB bitand b)
	<%
		const Vector3D e = b.extents();
		axis_t best = AXIS_x;
#define X(n, c) if (e.c > e<:best:>) best = AXIS_##c;
		AXES
#undef X
		return best;
	%>

	struct row
	<%
		unsigned where, depth, count;
		bool operator<(const row bitand o) const <% return count < o.count or (count == o.count and where > o.where); %>
	%>;
%>

void BVH::construct(const Mesh bitand mesh)
<%
	typedef std::vector<unsigned> faces_t;
	const unsigned n = (unsigned) mesh.getFaces().size();
	nodes.clear();
	faceIndices.clear();
	for (unsigned i = 0; i not_eq n; i++) faceIndices.push_back(i);
	nodes.push_back(Node<%mesh.getBounds(), 0, n%>);
	std::priority_queue<row> heap;
	heap.push(row<%0, 0, n%>);
	FOREVER
	<%
		if (heap.empty()) break;
		const row r = heap.top();
		heap.pop();
		if (r.count <= numFacesPerLeaf) break; // the largest one
		if (r.depth == maxDepth) continue;
		const Node p = nodes<:r.where:>;
		const axis_t a = longest(p.bounds);
		auto key = <:bitand:>(unsigned f) <%
			float sum = 0;
			const Triangle t = mesh.getTriangleFromFaceIndex(f);
%:define Y(v) sum += t.v<:a:>;
			CORNERS
#undef Y
			return sum / 3;
		%>;
		faces_t low(faceIndices.begin() + p.facesBegin, faceIndices.begin() + p.facesEnd);
		std::stable_sort(low.begin(), low.end(), <:bitand:>(unsigned l, unsigned r) <% return key(l) < key(r); %>);
		faces_t high(low.begin() + r.count / 2, low.end());
		low.resize(r.count / 2);
		UNLESS (2 * r.where + 2 < nodes.size()) nodes.resize(2 * r.where + 3);
		unsigned k = p.facesBegin, side = 1;
		for (const faces_t *half : <% bitand low, bitand high %>)
		<%
			Node bitand c = nodes<:2 * r.where + side:>;
			c.facesBegin = k;
			for (unsigned f : *half)
			<%
				const Triangle t = mesh.getTriangleFromFaceIndex(faceIndices<:k++:> = f);
%:define Y(v) c.bounds.extend(t.v);
				CORNERS
#undef Y
			%>
			c.facesEnd = k;
			heap.push(row<%2 * r.where + side++, r.depth + 1, c.facesEnd - c.facesBegin%>);
		%>
	%>
%>

Intersection intersect(const Mesh bitand mesh, const IntersectionRay bitand ray)
<%
	const auto bitand bvh = mesh.getBVH();
	const auto bitand all = bvh.getNodes();
	Intersection best = <%%>;
	UNLESS (bvh.isConstructed()) return best;
	std::list<unsigned> todo(1, 0u);
	while (not todo.empty())
	<%
		const unsigned i = todo.front(), l = (i << 1) bitor 1u, r = (i + 1) << 1;
		todo.pop_front();
		UNLESS (intersect(all<:i:>.bounds, ray)) continue;
		if (r < all.size() and all<:l:>.facesEnd not_eq 0 and all<:r:>.facesEnd not_eq 0)
			todo.insert(todo.begin(), <%l, r%>);
		else for (const auto f : bvh.getFaceIndices(all<:i:>))
		<%
			const Intersection h = intersect(mesh.getTriangleFromFaceIndex(f), ray);
			best = h and h.t < best.t ? h : best;
		%>
	%>
	return best;
%>
