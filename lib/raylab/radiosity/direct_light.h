#pragma once

#include "raylab/radiosity/visibility.h"

#include <vector>

namespace raylab {

/// What the scene's point, spot and distant lights give each patch: the power per area that arrives, as a mean over
/// `points` points of the patch, each with a shadow ray. A light gives pi color attenuation cos, so a white surface
/// that faces it has the radiance `color`, as in Whitted's model.
std::vector<Color> direct_light(const PatchMesh& mesh, const PatchVisibility& visibility, int points, int threads);

/// pi times the background's colour: what it gives a patch that sees nothing else. Of a background with a zenith it is
/// the mean of both colours.
Color background_light(const Background& background);

}  // namespace raylab
