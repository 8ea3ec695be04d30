#pragma once

#include "picture_words.h"

#include "raylab/tracer/picture/whitted_picture.h"

#include <string>

namespace raylab {

/// A small picture of the scene in which a pixel of the large one is ringed, as the bytes of a PNG.
std::string pixel_inset(const AskedPicture& picture, const PixelSample& pixel);

}  // namespace raylab
