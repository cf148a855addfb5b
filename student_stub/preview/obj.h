#pragma once

#include "mesh.h"

#include <filesystem>

namespace ex03 {

/// Reads the vertices (`v`) and faces (`f`) of a Wavefront OBJ file; polygons become triangles.
///
/// Everything else in the file (normals, texture coordinates, materials, groups) is skipped.
/// Throws std::runtime_error with file, line and what was expected if the file is not usable.
Mesh readObj(const std::filesystem::path& file);

} // namespace ex03
