#pragma once

#include "raylab/sampling/random.h"

#include <cstdint>

// The places inside a pixel through which rays pass. A pixel's square is divided into n x n equal cells, and each
// sample takes one.

namespace raylab {

/// A place inside a pixel: (0, 0) is its top left corner, (1, 1) its bottom right one.
struct PixelPoint {
    double x, y;
};

enum class SamplePattern {
    center,    // the middle of each cell
    corner,    // the top left corner of each cell
    jittered,  // anywhere in each cell (Cook, Porter, Carpenter: Distributed Ray Tracing, SIGGRAPH 1984)
    random,    // anywhere in the pixel
};

struct PixelSamples {
    SamplePattern pattern = SamplePattern::center;
    int per_side = 1;  // n: a pixel has n^2 samples
    std::uint64_t seed = 1;

    int count() const { return per_side * per_side; }
};

/// Sample number `index` (0 to count() - 1) of a pixel. Pixels are numbered so that no two share random numbers.
inline PixelPoint pixel_sample(const PixelSamples& samples, std::uint64_t pixel, int index) {
    const auto random = [&](std::uint64_t dimension) {
        return random_number({samples.seed, pixel, static_cast<std::uint64_t>(index), dimension});
    };
    if (samples.pattern == SamplePattern::random) return {random(0), random(1)};
    const int column = index % samples.per_side, row = index / samples.per_side;
    const auto in_cell = [&](int cell, std::uint64_t dimension) {
        if (samples.pattern == SamplePattern::center) return (cell + 0.5) / samples.per_side;
        if (samples.pattern == SamplePattern::corner) return 1.0 * cell / samples.per_side;
        return (cell + random(dimension)) / samples.per_side;
    };
    return {in_cell(column, 0), in_cell(row, 1)};
}

}  // namespace raylab
