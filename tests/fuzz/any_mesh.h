#pragma once

#include "raylab/base/error.h"
#include "raylab/scene/read_mesh.h"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>

// Any bytes are a whole mesh or an Error.
inline int read_any_mesh(const std::uint8_t* data, std::size_t size, raylab::MeshFormat format) {
    try {
        const auto mesh = raylab::read_mesh_bytes({reinterpret_cast<const char*>(data), size}, format, "fuzz");
        assert(!mesh.faces.empty());
        assert(mesh.normals.empty() || mesh.normals.size() == mesh.vertices.size());
        for (const auto& [a, b, c] : mesh.faces)
            for (const auto corner : {a, b, c}) assert(corner < mesh.vertices.size());
        for (const auto& v : mesh.vertices) assert(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z));
    } catch (const raylab::Error&) {
    }
    return 0;
}
