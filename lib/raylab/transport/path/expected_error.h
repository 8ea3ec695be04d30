#pragma once

#include "raylab/image/sampled_image.h"

namespace raylab {

/// The error that a sampled picture is expected to have: RMSE over all pixels over the mean radiance (of luminance).
struct ExpectedError {
    double value;
    double bound;  // in 95 of 100 pictures the error is below it, if the summands of each pixel are independent
};

/// Estimated from the pixels' own variances. The ratio of the squared error to its estimate is distributed as F with m
/// and m (n - 1) degrees of freedom, where n is the least number of summands and m the number of pixels that matter:
/// (sum of variances)^2 / sum of their squares.
ExpectedError expected_error(const SampledImage& image);

}  // namespace raylab
