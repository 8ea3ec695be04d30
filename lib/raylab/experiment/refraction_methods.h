#pragma once

#include "raylab/experiment/measure/method.h"
#include "raylab/geometry/vector.h"

#include <optional>
#include <variant>
#include <vector>

namespace raylab {

/// "Where does this ray go on behind this surface?" The directions are what these floats say, made unit; the normal is
/// on the side that the ray comes from.
struct RefractionQuery {
    Vec3f direction, normal;
    float ior_before, ior_behind;
};

/// A unit direction; absent: total internal reflection.
using RefractionMethod = Method<std::monostate, RefractionQuery, std::optional<Vec3d>>;

/// By angles, by Heckbert's root, by the same root factored, by the part along the surface; in float and in double.
std::vector<RefractionMethod> refraction_methods();

/// The function in the slot of exercise 07, under the name "yours".
RefractionMethod your_refraction_method();

/// The truth: total internal reflection decided in exact arithmetic, the direction made in 256 bits.
std::optional<Vec3d> exact_refraction(const RefractionQuery& query);

}  // namespace raylab
