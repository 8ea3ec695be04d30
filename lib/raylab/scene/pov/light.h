#pragma once

#include "raylab/scene/scene.h"

#include <string>

namespace raylab::pov {

/// Writes a light. Where POV-Ray cannot express its attenuation, it is exact at the camera's target only.
std::string light(const Light& light, const Camera& camera);

/// Whether POV-Ray can express 1 / (c + l d + q d^2): it can with c and one of the others, or with one alone.
bool says_attenuation(const Vec3d& attenuation);

}  // namespace raylab::pov
