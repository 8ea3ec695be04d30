#pragma once

#include "raylab/image/compare.h"
#include "raylab/image/sampled_image.h"

#include <string>
#include <vector>

// A picture that was sampled at random is never its reference, and a tolerance for each pixel would be a guess. But the
// reference knows the variance of its samples, so how far means over blocks may be apart follows. (Mitsuba 3 judges its
// renderers so, pixel by pixel: src/render/tests/test_renders.py.)

namespace raylab {

/// When a picture is not taken for its reference's scene.
struct NoisyTolerance {
    int samples = 1;      // rays a pixel that the picture is taken to have; evenly spread ones have less variance
    double alpha = 1e-5;  // the share of right pictures that all tests together may refuse
    int block = 8;        // edge of the windows whose means are compared, in pixels: sums of 64 are nearly normal
    // What a mean may be off besides: another filter at edges, another order of additions.
    Tolerance bias{.absolute = 1e-3, .relative = 1e-2};
    double firefly = 20;           // standard deviations of a pixel beyond which it is one
    double firefly_share = 0.002;  // of all pixels
};

/// The reasons why the picture is not one of the reference's scene; empty where it is. They come in the order: size,
/// finite values, blocks, the whole, single pixels.
std::vector<std::string> noisy_objections(const Image& image, const SampledImage& reference,
                                          const NoisyTolerance& tolerance);

}  // namespace raylab
