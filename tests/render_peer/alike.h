#pragma once

#include "raylab/image/compare.h"
#include "raylab/scene/scene.h"

// POV-Ray computes colours in float and stores them in half floats, its rays start 1e-3 m above surfaces, and it moves
// patterns by 1e-3 of a cell or less: edges of shadows, cells and silhouettes may be on the other side of a pixel's
// ray.
inline constexpr raylab::SamePicture alike{
    .outlier_share = 0.002, .tile_share = 1, .mean = {.absolute = 1e-4, .relative = 1e-3}};

/// Fails the running test where POV-Ray's picture of the scene differs from raylab's by Whitted's rays. Without POV-Ray
/// it prints that the test is skipped.
void check_alike(raylab::Scene scene, int depth, const raylab::SamePicture& same = alike);
