#pragma once

#include <glm/vec2.hpp>

#include <span>

namespace raylab {

/// The share of pixel (column, row), the square of side 1 whose top left corner it names, that a polygon covers, by
/// clipping and the surveyor's formula, so right to rounding. The polygon is simple, of either orientation.
double pixel_coverage(std::span<const glm::dvec2> polygon, int column, int row);

}  // namespace raylab
