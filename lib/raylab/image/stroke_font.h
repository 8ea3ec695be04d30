#pragma once

#include "raylab/image/draw.h"

#include <vector>

namespace raylab {

using Stroke = std::vector<Point2>;

/// A character as strokes, in units of which a capital is 12 high; y runs upward from the baseline.
struct Glyph {
    std::vector<Stroke> strokes;
    double advance;  // to the next character
};

/// Printable ASCII; a character the font lacks is drawn as '?'.
Glyph glyph(char character);

}  // namespace raylab
