#pragma once

#include "raylab/report/chapter.h"

namespace raylab::ray_generation {

/// The question `pixel_samples`: how much of a pixel does a triangle cover, by rays through samples of that pixel,
/// against the area of the triangle's picture clipped to the pixel.
Experiment measure_pixel_samples(const ChapterRun& run);

/// SAMPLE-SLOPE: how the error falls with the number of rays, against the theory.
StabilityCase sample_slope(const ChapterRun& run);

}  // namespace raylab::ray_generation
