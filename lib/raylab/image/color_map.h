#pragma once

#include "raylab/image/image.h"

namespace raylab {

/// A colour for a number in [0, 1]: black, purple, orange, yellow, nearly white. CIE lightness L* grows linearly from 0
/// to 97, so that equal steps look equal, in print and to colour-blind eyes too. NaN gets the colour of 0.
Pixel heat_color(double value);

}  // namespace raylab
