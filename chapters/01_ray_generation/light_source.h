#pragma once

#include "raylab/geometry/ray.h"
#include "raylab/scene/scene.h"

namespace raylab::ray_generation {

/// The distance in metres by which a ray starts above its surface; chapter 06 explains why it has to.
inline constexpr float skin = 1e-4f;

struct ShadingLight {
    Vec3d position;
    Color intensity;  // power per unit of solid angle
};

/// The one point light of a scene. It throws an Error where there is another number of lights, or another kind.
ShadingLight light_of(const Scene& scene);

/// The ray in floats that begins `start` metres along its unit direction and has no end.
Ray ray_from(const Vec3d& origin, const Vec3d& direction, float start);

}  // namespace raylab::ray_generation
