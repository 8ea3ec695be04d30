#pragma once

#include "raylab/image/image.h"

#include <string>

namespace raylab {

/// The script that tells a page the values of a picture's pixels, which it may not read from the picture where it was
/// opened as a file. It calls raylab_values(png), a data: address of a picture of twice the height. The upper half has
/// a mantissa of 8 bits for each colour, the lower half their exponent plus 136 (G. Ward, Real Pixels, Graphics Gems
/// II, 1991): a colour is mantissa * 2^(exponent - 136), off by at most 1/256 of the pixel's largest one. It expects
/// finite values; those below zero become zero.
std::string pixel_values_script(const Image& image);

/// "still_life_values.js", which stands beside "still_life.png".
std::string pixel_values_file(const std::string& picture);

}  // namespace raylab
