#pragma once

#include "raylab/image/image.h"

namespace raylab::cornell {

/// How far one picture is from another, in false colour: |difference| of the mean of the channels, relative to the mean
/// of the truth without its lights, with a scale below.
Image error_picture(const Image& picture, const Image& truth);

}  // namespace raylab::cornell
