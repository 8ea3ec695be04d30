#pragma once

#include "raylab/image/draw.h"

#include <vector>

namespace raylab {

using Stroke = std::vector<Point2>;

/// A character as strokes, in units in which a capital is 12 high; y grows upward from the baseline.
struct Glyph {
    std::vector<Stroke> strokes;
    double advance;  // distance to the next character
};

/// The strokes of a printable ASCII character; any other gets those of '?'.
Glyph glyph(char character);

}  // namespace raylab
