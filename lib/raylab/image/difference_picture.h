#pragma once

#include "raylab/image/compare.h"

namespace raylab {

/// For people: the picture, its reference and between them where they differ (FLIP in heat colours, brighter is worse),
/// side by side, the worst pixels circled and some of the windows over budget framed in all of them. Pictures that
/// cannot be compared are shown beside each other, a cross on the first pixel that is not finite.
Image difference_picture(const Image& image, const Image& reference, const Comparison& comparison);

}  // namespace raylab
