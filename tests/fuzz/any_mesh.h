#pragma once

#include "raylab/scene/mesh/read_mesh.h"

#include "fuzz/value_or_error.h"

#include <cassert>
#include <cmath>

// Any bytes must give a valid mesh or an Error.
inline int read_any_mesh(const std::uint8_t* data, std::size_t size, raylab::MeshFormat format) {
    return value_or_error(data, size, [&](std::string_view bytes) {
        const auto mesh = raylab::read_mesh_bytes(bytes, format, "fuzz");
        assert(!mesh.faces.empty());
        assert(mesh.normals.empty() || mesh.normals.size() == mesh.vertices.size());
        for (const auto& [a, b, c] : mesh.faces)
            for (const auto corner : {a, b, c}) assert(corner < mesh.vertices.size());
        for (const auto& v : mesh.vertices) assert(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z));
    });
}
