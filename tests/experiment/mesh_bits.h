#pragma once

#include "raylab/geometry/shapes.h"

#include <bit>
#include <cstdint>

namespace raylab {

// FNV-1a over the bits of all coordinates.
inline std::uint64_t fingerprint(const Mesh& mesh) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const auto& v : mesh.vertices)
        for (const float coordinate : {v.x, v.y, v.z})
            hash = (hash ^ std::bit_cast<std::uint32_t>(coordinate)) * 0x100000001b3u;
    return hash;
}

}  // namespace raylab
