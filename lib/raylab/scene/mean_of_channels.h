#pragma once

#include "raylab/scene/scene.h"

namespace raylab {

/// One number for a colour whose channels count alike, as where a structure is refined or powers are summed. Eyes weigh
/// them: see luminance().
inline double mean_of_channels(const Color& color) { return (color.r + color.g + color.b) / 3; }

}  // namespace raylab
