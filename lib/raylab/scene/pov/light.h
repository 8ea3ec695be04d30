#pragma once

#include "raylab/scene/scene.h"

#include <string>

namespace raylab::pov {

/// A light. Where POV-Ray cannot say its attenuation, it is right at the camera's target.
std::string light(const Light& light, const Camera& camera);

/// Whether POV-Ray can say 1 / (c + l d + q d^2): it can with c and one of the others, or one alone.
bool says_attenuation(const Vec3d& attenuation);

}  // namespace raylab::pov
