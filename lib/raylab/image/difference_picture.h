#pragma once

#include "raylab/image/compare.h"

namespace raylab {

/// A picture for people: the picture, their difference (FLIP in heat colours, brighter is worse) and the reference,
/// side by side, with the worst pixels circled and some of the windows that exceed the tolerance framed in all of them.
/// Pictures that cannot be compared are shown beside each other, with a cross on the first pixel that is not finite.
Image difference_picture(const Image& image, const Image& reference, const Comparison& comparison);

}  // namespace raylab
