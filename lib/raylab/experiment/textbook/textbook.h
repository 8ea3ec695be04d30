#pragma once

#include "raylab/experiment/textbook/textbook_surface.h"
#include "raylab/geometry/ray.h"
#include "raylab/scene/scene.h"
#include "raylab/tracer/whitted/ray_tree.h"

// Whitted's recursion as a textbook has it: in doubles, every object asked in turn, and made of the five functions that
// exercises replace: phong_specular (05), local_color (05b), in_shadow (06), refracted_direction (07), traced_color
// (07b). So a picture that one of them spoils can be followed to the ray that goes wrong first.

namespace raylab {

/// All rays that one eye ray spawns, the eye ray having depth 1, and none deeper than `limit`. Weights and local
/// colours are what traced_color makes of its parts, found by asking it: it should add shares of what its rays bring.
RayTree textbook_tree(const Scene& scene, const RayOf<double>& eye_ray, int limit);

}  // namespace raylab
