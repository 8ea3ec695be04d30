#pragma once

#include "raylab/geometry/shapes.h"

#include <algorithm>

// Whether two meshes are the same, coordinate by coordinate and corner by corner.

inline bool same_vertices(const raylab::Mesh& a, const raylab::Mesh& b) { return a.vertices == b.vertices; }

inline bool same_faces(const raylab::Mesh& a, const raylab::Mesh& b) {
    return std::ranges::equal(a.faces, b.faces,
                              [](const auto& f, const auto& g) { return f.a == g.a && f.b == g.b && f.c == g.c; });
}

/// Whether two meshes have the same triangles, whatever the numbers of their vertices.
inline bool same_triangles(const raylab::Mesh& a, const raylab::Mesh& b) {
    if (a.faces.size() != b.faces.size()) return false;
    for (std::size_t face = 0; face < a.faces.size(); ++face) {
        const auto s = a.triangle(face), t = b.triangle(face);
        if (s.a != t.a || s.b != t.b || s.c != t.c) return false;
    }
    return true;
}
