#pragma once

#include "bvh.h"
#include "triangle.h"

/// Triangles that share their corners: a list of points, and three indices into it per face.
class Mesh {
  public:
    Mesh() = default;

    /// Every index in `faces` must be below the number of vertices. Does not build the BVH.
    Mesh(std::vector<Point3D> vertices, std::vector<TriangleIndices> faces);

    const std::vector<Point3D>& getVertices() const { return vertices; }
    const std::vector<TriangleIndices>& getFaces() const { return faces; }

    /// The box of all vertices, also of those that no face uses. Empty if there are none.
    const AABB& getBounds() const { return bounds; }

    Triangle getTriangleFromFace(const TriangleIndices& face) const {
        return {vertices[face.v1], vertices[face.v2], vertices[face.v3]};
    }

    Triangle getTriangleFromFaceIndex(size_t index) const {
        return getTriangleFromFace(faces[index]);
    }

    const BVH& getBVH() const { return bvh; }

  private:
    friend struct ex03::Access; // lets the grader construct the tree

    std::vector<Point3D> vertices;
    std::vector<TriangleIndices> faces;
    AABB bounds;
    BVH bvh;
};
