#include "mesh.h"

Mesh::Mesh(std::vector<Point3D> vertices, std::vector<TriangleIndices> faces)
    : vertices(std::move(vertices)), faces(std::move(faces)) {
    for (const Point3D& vertex : this->vertices) {
        bounds.extend(vertex);
    }
}
