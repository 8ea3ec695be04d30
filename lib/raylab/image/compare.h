#pragma once

#include "raylab/image/finite.h"
#include "raylab/image/flip.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

// How far a picture is from its reference, and whether that is the same picture. A per-pixel maximum alone must not
// decide: one edge pixel may flip although everything is right.

namespace raylab {

/// What a value may be off: absolute + relative |reference|.
struct Tolerance {
    double absolute = 1e-3, relative = 1e-3;
};

/// The one comparison of the lab's picture verdicts. Written positively, so that NaN and infinity on either side fail.
inline bool within(double difference, double reference, const Tolerance& tolerance) {
    constexpr double largest = std::numeric_limits<double>::max();
    return std::abs(reference) <= largest &&
           std::abs(difference) <= tolerance.absolute + tolerance.relative * std::abs(reference);
}

/// What makes two pictures the same.
struct SamePicture {
    Tolerance pixel;                                     // of each channel
    double outlier_share = 0.005;                        // of the picture's pixels may be over it
    int tile = 8;                                        // pixels, edge of the windows below
    double tile_share = 0.25;                            // of any window's pixels may be over it: a small object counts
    Tolerance mean{.absolute = 1e-6, .relative = 2e-3};  // of each channel's mean; 1e-6: a thousandth of a pixel's
};

/// One pixel of both pictures.
struct PixelPair {
    int x, y;
    Pixel value, reference;
    double error;  // the largest of the channels' absolute differences
};

/// A window with too many pixels over tolerance.
struct BadTile {
    int x, y, width, height;
    double share;  // of its pixels
};

/// Everything that is known about a picture and its reference. Where the sizes differ or a value is not finite, the
/// numbers below `bits_differ` have no meaning and stay as they are.
struct Comparison {
    int width = 0, height = 0, reference_width = 0, reference_height = 0;
    std::optional<PixelAt> non_finite, reference_non_finite;  // the first of each
    std::size_t bits_differ = 0;  // pixels with any bit other than the reference's; 0 where sizes differ

    double max_error = 0;     // of one channel
    double rmse = 0;          // over all channels
    double relative_mse = 0;  // mean of (x - y)^2 / (y^2 + 0.01 mean(y)^2), y the reference
    double mean_flip = 0;
    double share_over = 0;  // of pixels
    Pixel mean, reference_mean;
    std::vector<PixelPair> worst;  // at most ten, the worst first; one of each 8 x 8 block
    std::vector<BadTile> bad_tiles;

    bool same_size() const { return width == reference_width && height == reference_height; }
    bool comparable() const { return same_size() && !non_finite && !reference_non_finite; }
};

/// Compares pictures of any sizes and values; an empty picture equals an empty one.
Comparison compare(const Image& image, const Image& reference, const SamePicture& same = {});

/// Why the pictures are not the same, as sentences; empty: they are. In order: size, finite values, then the rest.
std::vector<std::string> objections(const Comparison& comparison, const SamePicture& same = {});

/// Why the pictures are not the same bits; empty: they are.
std::vector<std::string> exact_objections(const Comparison& comparison);

}  // namespace raylab
