#pragma once

#include "raylab/geometry/ray.h"
#include "raylab/scene/scene.h"

namespace raylab::ray_generation {

/// Metres that a ray starts off its surface; why it has to is chapter 06's subject.
inline constexpr float skin = 1e-4f;

struct Lamp {
    Vec3d position;
    Color intensity;  // power a unit of solid angle
};

/// The one point light of a scene. Error where there is another number of lights, or another kind.
Lamp lamp_of(const Scene& scene);

/// The floats of a ray that goes on without end from `start` metres along its unit direction.
Ray ray_from(const Vec3d& origin, const Vec3d& direction, float start);

}  // namespace raylab::ray_generation
