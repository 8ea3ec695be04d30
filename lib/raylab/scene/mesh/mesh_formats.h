#pragma once

#include "raylab/base/memory_limit.h"
#include "raylab/geometry/shapes.h"

#include <string>
#include <string_view>

// One reader for each format; read_mesh.h chooses among them.

namespace raylab {

/// Geomview's OFF in text, including COFF, NOFF, STOFF and their mixtures. A line holds one vertex or one face; colours
/// and texture coordinates are not kept.
Mesh read_off(std::string_view bytes, const std::string& name, const MemoryLimit& limit);

/// Wavefront OBJ: v, vn and f with every form of index. Materials, groups, texture coordinates, points and lines are
/// skipped; free-form surfaces are refused. Normals are kept if every vertex has only one: an OBJ file may give each
/// corner its own, but vertices are not split here.
Mesh read_obj(std::string_view bytes, const std::string& name, const MemoryLimit& limit);

/// PLY: text, little and big endian. Elements and properties other than positions, normals and faces are skipped.
Mesh read_ply(std::string_view bytes, const std::string& name, const MemoryLimit& limit);

/// STL: text and binary, told apart by size and content (a binary file may begin with "solid" as well). Vertices with
/// equal coordinates become one, in order of appearance; facet normals are not kept, because the vertices determine
/// them more accurately.
Mesh read_stl(std::string_view bytes, const std::string& name, const MemoryLimit& limit);

}  // namespace raylab
