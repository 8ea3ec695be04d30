#pragma once

#include "raylab/scene/scene.h"

#include <string>

namespace raylab::pov {

/// Writes a light. Where POV-Ray cannot express its attenuation, it is exact at the camera's target only.
std::string light(const Light& light, const Camera& camera);

/// A light with further words of POV-Ray's. An attenuation that it cannot express is exact at this distance.
std::string light_source(const Vec3d& position, const Color& color, const std::string& words, const Vec3d& attenuation,
                         double distance);

/// Whether POV-Ray can express 1 / (c + l d + q d^2): it can with c and one of the others, or with one alone.
bool says_attenuation(const Vec3d& attenuation);

}  // namespace raylab::pov
