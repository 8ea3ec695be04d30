#pragma once

#include "raylab/base/memory_limit.h"
#include "raylab/geometry/shapes.h"

#include <string>
#include <string_view>

// One reader a format; read_mesh.h chooses among them.

namespace raylab {

/// Geomview's OFF in text: COFF, NOFF, STOFF and their mixtures too. One vertex and one face a line; colours and
/// texture coordinates are not kept.
Mesh read_off(std::string_view bytes, const std::string& name, const MemoryLimit& limit);

/// Wavefront OBJ: v, vn and f with every form of index; materials, groups, texture coordinates, points and lines are
/// passed over, free-form surfaces refused. Normals are kept where no vertex has two of them: an OBJ may give each
/// corner its own, but vertices are not split here.
Mesh read_obj(std::string_view bytes, const std::string& name, const MemoryLimit& limit);

/// PLY: text, little and big endian. Elements and properties other than positions, normals and faces are passed over.
Mesh read_ply(std::string_view bytes, const std::string& name, const MemoryLimit& limit);

/// STL: text and binary, told apart by size and content (a binary file may begin with "solid" as well). Vertices with
/// equal coordinates become one, in order of appearance; facet normals are not kept, as the vertices say them better.
Mesh read_stl(std::string_view bytes, const std::string& name, const MemoryLimit& limit);

}  // namespace raylab
