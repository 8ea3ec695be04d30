#pragma once

#include <optional>
#include <string_view>

namespace raylab {

/// What a page must know of an SVG drawing to show it so large that it can be read.
struct DrawingSize {
    double width, height;                        // in the drawing's own units
    std::optional<double> smallest_letter = {};  // font size, in the same units; absent: no letters
};

/// The size that a drawing's viewBox states; absent where it has none.
std::optional<DrawingSize> drawing_size(std::string_view svg);

}  // namespace raylab
