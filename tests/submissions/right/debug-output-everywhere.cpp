// right: handed in at 23:58: debug output, a log file, timing, system("pause"), std::cin.get(), dead code and warnings everywhere
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"
#include <iostream>
#include <fstream>
#include <chrono>
#include <ctime>
#include <cstdio>
#include <cstdlib>
#include <cassert>
#include <string>
#include <algorithm>
#include <vector>
#ifdef _WIN32
#define NOMINMAX
#include <windows.h>
#endif

#pragma warning(disable : 4996)
#pragma region Hilfsfunktionen

#define DEBUG_PRINT(x) std::cout << #x << " = " << (x) << std::endl
//#define USE_BRUTE_FORCE

using namespace std;

int cnt = 0; // wie oft construct lief
bool debug = true;
ofstream logFile;

float getTriangleCenter(const Mesh& mesh, int index, int axis)
{
	Triangle tri = mesh.getTriangleFromFaceIndex(index);
	float c;
	if (axis == 0)
		c = (tri.v1.x + tri.v2.x + tri.v3.x) / 3.0;
	else if (axis == 1)
		c = (tri.v1.y + tri.v2.y + tri.v3.y) / 3.0;
	else if (axis == 2)
		c = (tri.v1.z + tri.v2.z + tri.v3.z) / 3.0;
	return c;
}

ostream& operator<<(ostream& os, const Point3D& p) { return os << "(" << p.x << ", " << p.y << ", " << p.z << ")"; }
ostream& operator<<(ostream& os, const AABB& b) { return os << b.min << " - " << b.max; }

// alte Version, geht nicht!!!
static void constructOld(const Mesh& mesh, int node, int depth)
{
	//constructOld(mesh, 2 * node + 1, depth + 1);
	//constructOld(mesh, 2 * node + 2, depth + 1);
}
#pragma endregion

void BVH::construct(const Mesh& mesh)
{
	ios::sync_with_stdio(true);
	srand(time(NULL));
	auto start = chrono::high_resolution_clock::now();
	cnt++;
	if (!logFile.is_open())
		logFile.open("bvh_log.txt", ios::app);
	logFile << "construct Nr. " << cnt << " mit " << mesh.getFaces().size() << " Dreiecken" << endl;
	printf("baue BVH fuer %zu Dreiecke...\n", mesh.getFaces().size());

	*this = {};
	int numFaces = mesh.getFaces().size();
	for (int i = 0; i < numFaces; i++)
		faceIndices.push_back(i);
	Node root;
	root.bounds = mesh.getBounds();
	root.facesBegin = 0;
	root.facesEnd = numFaces;
	nodes.push_back(root);
	DEBUG_PRINT(root.bounds);

	int unused;
	int anzahlBlaetter = 0;
	for (int i = 0; i < nodes.size(); i++)
	{
		int anzahl = nodes[i].facesEnd - nodes[i].facesBegin;
		int tiefe = floor(log2(i + 1));
		if (anzahl <= 4)
		{
			if (anzahl > 0)
				anzahlBlaetter++;
			continue;
		}
		if (tiefe >= 20)
			break;
		if (debug && i < 10000)
			std::cout << "Knoten " << i << ": " << anzahl << " Dreiecke, Tiefe " << tiefe << ", Box " << nodes[i].bounds << std::endl;

		Vector3D ausdehnung = nodes[i].bounds.extents();
		int axis = 0;
		if (ausdehnung.y > ausdehnung.x) axis = 1;
		if (ausdehnung.z > ausdehnung[axis]) axis = 2;
		assert(axis >= 0 && axis < 3);

		// beide Kinder muessen in den Vektor passen
		while (nodes.size() < 2 * i + 3)
		{
			Node leer;
			nodes.push_back(leer);
		}
		int mitte = (nodes[i].facesBegin + nodes[i].facesEnd) / 2;
		nth_element(faceIndices.begin() + nodes[i].facesBegin, faceIndices.begin() + mitte, faceIndices.begin() + nodes[i].facesEnd,
			[&](int a, int b) { return getTriangleCenter(mesh, a, axis) < getTriangleCenter(mesh, b, axis); });
		nodes[2 * i + 1].facesBegin = nodes[i].facesBegin;
		nodes[2 * i + 1].facesEnd = mitte;
		nodes[2 * i + 2].facesBegin = mitte;
		nodes[2 * i + 2].facesEnd = nodes[i].facesEnd;
		for (int j = nodes[i].facesBegin; j < mitte; j++)
		{
			Triangle t = mesh.getTriangleFromFaceIndex(faceIndices[j]);
			nodes[2 * i + 1].bounds.extend(t.v1);
			nodes[2 * i + 1].bounds.extend(t.v2);
			nodes[2 * i + 1].bounds.extend(t.v3);
		}
		for (int j = mitte; j < nodes[i].facesEnd; j++)
		{
			Triangle t = mesh.getTriangleFromFaceIndex(faceIndices[j]);
			nodes[2 * i + 2].bounds.extend(t.v1);
			nodes[2 * i + 2].bounds.extend(t.v2);
			nodes[2 * i + 2].bounds.extend(t.v3);
		}
	}

	auto ende = chrono::high_resolution_clock::now();
	cout << "fertig nach " << chrono::duration_cast<chrono::milliseconds>(ende - start).count() << " ms" << endl;
	cerr << "Knoten: " << nodes.size() << " Blaetter: " << anzahlBlaetter << endl;
	fprintf(stderr, "Zufall: %d, HOME=%s\n", rand(), getenv("HOME") ? getenv("HOME") : "?");
	if (cnt == 1)
	{
		system("pause");
		cin.get();
		getchar();
	}
}

// rekursiv, weil nur a) eine Schleife verlangt
void traverse(const Mesh& mesh, const BVH& bvh, const IntersectionRay& ray, int nodeIndex, Intersection& best, int depth)
{
	const vector<BVH::Node>& nodes = bvh.getNodes();
	if (nodeIndex >= nodes.size())
		return;
	if (nodes[nodeIndex].facesEnd == 0)
		return;
	if (!intersect(nodes[nodeIndex].bounds, ray))
		return;
	if (nodeIndex * 2 + 1 >= nodes.size() || nodes[nodeIndex * 2 + 1].facesEnd == 0)
	{
		for (uint32_t faceIndex : bvh.getFaceIndices(nodes[nodeIndex]))
		{
			Intersection is = intersect(mesh.getTriangleFromFaceIndex(faceIndex), ray);
			if (is && is.t < best.t)
			{
				best = is;
				//cout << "Treffer! t=" << is.t << endl;
			}
		}
		return;
	}
	traverse(mesh, bvh, ray, nodeIndex * 2 + 1, best, depth + 1);
	traverse(mesh, bvh, ray, nodeIndex * 2 + 2, best, depth + 1);
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray)
{
#ifdef USE_BRUTE_FORCE
	Intersection b;
	for (int i = 0; i < mesh.getFaces().size(); i++) {
		Intersection is = intersect(mesh.getTriangleFromFaceIndex(i), ray);
		if (is.t < b.t) b = is;
	}
	return b;
#else
	static thread_local int rayCount = 0;
	if (++rayCount % 10000 == 0)
		cout << rayCount << " Strahlen..." << endl;
	Intersection best;
	best.t = INFINITY;
	traverse(mesh, mesh.getBVH(), ray, 0, best, 0);
	return best;
#endif
}
