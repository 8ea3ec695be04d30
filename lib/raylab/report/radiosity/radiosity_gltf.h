#pragma once

#include "raylab/report/radiosity/solved_scene.h"

#include <string>

namespace raylab {

/// The bytes of a binary glTF 2.0 file (.glb) of a solved scene, which viewers show without any light of their own
/// (KHR_materials_unlit). COLOR_0 is the radiance times the exposure, clamped to [0, 1], linear, as the format asks;
/// _RADIANCE is the radiance as it is. One triangle mesh, its vertices shared as the radiosities are interpolated.
std::string radiosity_gltf(const SolvedScene& solved, double exposure);

/// The exposure at which the brightest twentieth of the area is white.
double exposure_for(const SolvedScene& solved);

}  // namespace raylab
