#pragma once

#include "raylab/scene/scene.h"

#include <string>

namespace raylab::pov {

/// The light that an object sends out: a grid of points on it, moved at random inside their cells, in the models in
/// which what emits lights others. `points` is the number of a shadow ray's targets, rounded to a square. Empty where
/// it emits nothing or its shape cannot be said: POV-Ray has rectangles, disks and spheres.
std::string area_light(const Object& object, const Scene& scene, int points);

/// Whether an object emits, and lights others.
bool is_light(const Object& object, const Scene& scene);

/// Whether area_light() can say it.
bool says_area_light(const Object& object);

}  // namespace raylab::pov
