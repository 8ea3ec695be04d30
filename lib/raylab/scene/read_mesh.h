#pragma once

#include "raylab/base/memory_limit.h"
#include "raylab/geometry/shapes.h"

#include <filesystem>
#include <string>
#include <string_view>

// Meshes from files. What all formats share:
// - A vertex is the float nearest to what the file says. What is not finite, or too large for a float, is refused.
// - Polygons are fanned from their first corner, in file order, so that triangle k is the same for everyone. Nothing is
//   dropped: a triangle without area, one that repeats an index included, keeps its number and is never hit.
// - Normals are kept where each vertex has one (as written: any length), else the mesh has none.
// - Damaged files are refused: Error names file and line (text) or byte (binary), what was expected, what was found.

namespace raylab {

enum class MeshFormat { off, obj, ply, stl };

/// By the file's extension, upper or lower case. Error for any other.
MeshFormat mesh_format(const std::filesystem::path& path);

/// Reads a mesh file of at most 2 GiB: so every line, vertex and triangle has a number that fits 32 bits. Error, before
/// it is taken, for more memory than the limit: a byte may be a corner, and a triangle of 12 bytes.
Mesh read_mesh(const std::filesystem::path& path, const MemoryLimit& limit = {});

/// The same from memory; `name` stands for the file in messages.
Mesh read_mesh_bytes(std::string_view bytes, MeshFormat format, const std::string& name, const MemoryLimit& limit = {});

}  // namespace raylab
