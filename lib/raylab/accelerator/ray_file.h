#pragma once

#include "raylab/geometry/ray.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Rays and hits in bulk, as files hold them: little-endian, no header, one record after the other.

namespace raylab {

/// Reads rays of eight float32 each: ox oy oz tmin dx dy dz tmax. It throws an Error that names `source` and the ray
/// (from 0) for a partial record, for a number that is not finite (tmax may be +infinity), and for a direction of zero
/// length. tmin > tmax is an empty range, and such a ray hits nothing.
std::vector<Ray> rays_from_bytes(std::string_view bytes, const std::string& source);

std::string to_bytes(std::span<const Ray> rays);

/// The answer to one ray: the triangle of the mesh (in file order, -1: none) and t, the float nearest to Hit::t. t is
/// +infinity where there is no hit, and where a hit's t is too large for a float: the triangle tells the two apart.
struct HitRecord {
    std::int32_t triangle;
    float t;

    friend bool operator==(const HitRecord&, const HitRecord&) = default;
};

/// Writes hits of eight bytes each: int32 triangle, float32 t.
std::string to_bytes(std::span<const HitRecord> hits);

}  // namespace raylab
