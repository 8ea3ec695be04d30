#pragma once

#include "raylab/base/memory_limit.h"
#include "raylab/geometry/shapes.h"

#include <filesystem>
#include <string>
#include <string_view>

// Meshes from files. These rules hold for all formats:
// - A coordinate is the float nearest to the number in the file. A number that is not finite, or too large for a float,
//   is refused.
// - Polygons are fanned from their first corner, in file order, so that triangle k is the same for everyone. Nothing is
//   dropped: a triangle without area, one that repeats an index included, keeps its number and is never hit.
// - Normals are kept, with the length they have in the file, if each vertex has one; otherwise the mesh has none.
// - Damaged files are refused: the Error names the file and the line (text) or byte (binary), what was expected and
//   what was found.

namespace raylab {

enum class MeshFormat { off, obj, ply, stl };

/// The format by the file's extension, in upper or lower case. It throws an Error for any other extension.
MeshFormat mesh_format(const std::filesystem::path& path);

/// Reads a mesh file of at most 2 GiB, so that every line, vertex and triangle has a number of 32 bits. It throws an
/// Error before it allocates more memory than the limit: a byte of the file may be a corner, and so a triangle of 12
/// bytes.
Mesh read_mesh(const std::filesystem::path& path, const MemoryLimit& limit = {});

/// Reads a mesh from memory; `name` stands for the file in messages.
Mesh read_mesh_bytes(std::string_view bytes, MeshFormat format, const std::string& name, const MemoryLimit& limit = {});

}  // namespace raylab
