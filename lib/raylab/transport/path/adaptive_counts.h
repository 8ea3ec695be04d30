#pragma once

#include "raylab/image/sampled_image.h"

#include <vector>

namespace raylab {

/// How many samples each pixel gets, `mean` of them on the average: in proportion to its deviation, which for a given
/// sum makes the mean squared error least (Neyman, "On the Two Different Aspects of the Representative Method", 1934).
/// The deviation is that of a first picture, over the pixel and its neighbours: four samples that agree by chance prove
/// nothing (case THIN-PENUMBRA). No pixel gets fewer than `fewest`, a power of two, and each gets one: so many of
/// Sobol's points are spread most evenly.
///
/// The picture that decides must not be a part of the picture that is decided on: a pixel that was too dark by chance
/// would get fewer samples to mend it (case ADAPTIVE-BIAS; Kirk and Arvo, "Unbiased Sampling Techniques for Image
/// Synthesis", SIGGRAPH 1991).
std::vector<int> adaptive_counts(const SampledImage& first, int mean, int fewest = 4);

}  // namespace raylab
