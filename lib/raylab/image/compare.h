#pragma once

#include "raylab/image/finite.h"
#include "raylab/image/flip.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

// Measures how far a picture is from its reference, and decides whether they are the same picture. The maximum over
// pixels alone must not decide: one pixel at an edge may change although everything is right.

namespace raylab {

/// The permitted difference of a value: absolute + relative |reference|.
struct Tolerance {
    double absolute = 1e-3, relative = 1e-3;
};

/// The one comparison behind the lab's verdicts on pictures. It is written positively, so that NaN and infinity on
/// either side fail.
inline bool within(double difference, double reference, const Tolerance& tolerance) {
    constexpr double largest = std::numeric_limits<double>::max();
    return std::abs(reference) <= largest &&
           std::abs(difference) <= tolerance.absolute + tolerance.relative * std::abs(reference);
}

/// The criteria for two pictures to be the same.
struct SamePicture {
    Tolerance pixel;               // of each channel
    double outlier_share = 0.005;  // of the picture's pixels that may exceed it
    int tile = 8;                  // edge of the windows below, in pixels
    // The share of any window's pixels that may exceed it, so that a small object counts.
    double tile_share = 0.25;
    // The tolerance of each channel's mean; 1e-6 is a thousandth of a pixel's tolerance.
    Tolerance mean{.absolute = 1e-6, .relative = 2e-3};
};

/// One pixel of both pictures.
struct PixelPair {
    int x, y;
    Pixel value, reference;
    double error;  // the largest of the channels' absolute differences
};

/// A window in which too many pixels exceed the tolerance.
struct BadTile {
    int x, y, width, height;
    double share;  // of its pixels
};

/// The differences of a picture from its reference. Where the sizes differ or a value is not finite, the members below
/// `bits_differ` have no meaning and keep their initial values.
struct Comparison {
    int width = 0, height = 0, reference_width = 0, reference_height = 0;
    std::optional<PixelAt> non_finite, reference_non_finite;  // the first of each
    std::size_t bits_differ = 0;  // pixels with any bit different from the reference's; 0 where sizes differ

    double max_error = 0;     // of one channel
    double rmse = 0;          // over all channels
    double relative_mse = 0;  // mean of (x - y)^2 / (y^2 + 0.01 mean(y)^2), y the reference
    double mean_flip = 0;
    double share_over = 0;  // of pixels
    Pixel mean{}, reference_mean{};
    std::vector<PixelPair> worst;  // at most ten, the worst first; one of each 8 x 8 block
    std::vector<BadTile> bad_tiles;

    bool same_size() const { return width == reference_width && height == reference_height; }
    bool comparable() const { return same_size() && !non_finite && !reference_non_finite; }
};

/// Compares pictures of any sizes and values; two empty pictures are equal.
Comparison compare(const Image& image, const Image& reference, const SamePicture& same = {});

/// The reasons why the pictures are not the same, as sentences; empty where they are. They come in the order: size,
/// finite values, the rest.
std::vector<std::string> objections(const Comparison& comparison, const SamePicture& same = {});

/// The reasons why the pictures do not have the same bits; empty where they have.
std::vector<std::string> exact_objections(const Comparison& comparison);

}  // namespace raylab
