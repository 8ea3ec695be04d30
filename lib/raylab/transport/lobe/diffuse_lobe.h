#pragma once

#include "raylab/transport/lobe/lobe_sample.h"

#include <array>
#include <optional>

// A lobe says how a surface scatters light. All directions are unit vectors that lead away from the surface, in a frame
// in which the normal on the side of `wo`, the direction to the eye, is z: so wo.z > 0. `wi` leads to the light.
// `value` is the scattering function f times |cos wi|; `pdf` is the density per steradian with which `sample` chooses
// wi; both count no delta.

namespace raylab {

/// The same radiance in all directions: f = albedo / pi.
struct DiffuseLobe {
    Color albedo;

    Color value(const Vec3d& wo, const Vec3d& wi) const;
    double pdf(const Vec3d& wo, const Vec3d& wi) const;
    std::optional<LobeSample> sample(const Vec3d& wo, const std::array<double, 2>& numbers) const;
};

}  // namespace raylab
