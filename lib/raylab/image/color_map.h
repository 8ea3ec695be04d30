#pragma once

#include "raylab/image/image.h"

namespace raylab {

/// A colour for a number in [0, 1]: black, purple, orange, yellow, nearly white. CIE lightness L* grows from 0 to 97 in
/// a straight line, so that equal steps look equal, in print and to colour-blind eyes too. 0 for what is not a number.
Pixel heat_color(double value);

}  // namespace raylab
