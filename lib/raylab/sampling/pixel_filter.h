#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Which part of the picture around its centre a pixel shows: filters, sampled in proportion to their size, so that all
// samples of a pixel count alike. (Ernst, Stamminger and Greiner, "Filter Importance Sampling", 2006.)

namespace raylab {

enum class PixelFilter {
    box,       // 1 over the pixel's square
    tent,      // falls to 0 at a distance of one pixel
    gaussian,  // of standard deviation 1/2, cut off at two pixels
    mitchell,  // Mitchell and Netravali's with B = C = 1/3 (SIGGRAPH 1988): it sharpens, and is negative beyond 8/7
};

/// A point in pixels from the pixel's centre.
struct FilterSample {
    double x, y;
    double weight;  // the mean of all weights is 1
};

/// The point that two numbers in [0, 1) stand for.
FilterSample filter_sample(PixelFilter filter, const std::array<double, 2>& numbers);

/// The filter's value at a distance along one axis, in pixels; its integral is 1. A filter is the product of two.
double filter_value(PixelFilter filter, double x);

/// The name in options: "mitchell".
std::string to_string(PixelFilter filter);

/// All names, in the order of PixelFilter.
std::vector<std::string> filter_names();

/// The filter of this name; absent: there is none.
std::optional<PixelFilter> pixel_filter(std::string_view name);

}  // namespace raylab
