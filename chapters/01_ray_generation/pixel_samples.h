#pragma once

#include "raylab/report/chapter.h"

#include <string>
#include <vector>

namespace raylab::ray_generation {

/// The question `pixel_samples`: how much of a pixel a triangle covers, by rays through samples of that pixel, against
/// the area of the triangle's picture clipped to the pixel.
Experiment measure_pixel_samples(const ChapterRun& run);

/// The RMS errors over slanted edges: a row for each number of rays and one for their slope (README, "Where in the
/// pixel?").
std::vector<std::vector<std::string>> sample_error_rows(const ChapterRun& run);
std::vector<std::string> sample_error_header();

/// SAMPLE-SLOPE: how the error falls with the number of rays, compared with the theory.
StabilityCase sample_slope(const ChapterRun& run);

}  // namespace raylab::ray_generation
