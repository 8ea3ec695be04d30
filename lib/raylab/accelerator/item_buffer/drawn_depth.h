#pragma once

#include <array>
#include <optional>

namespace raylab {

/// A corner of a triangle that was projected into the picture.
struct DrawnCorner {
    double x, y;   // its place in the picture, in pixels or any other unit
    double depth;  // its distance from the eye along the direction of the view, positive
};

/// The depth at which a triangle is seen at the place (x, y) of the picture; absent where its image does not cover this
/// place. Its edges and corners belong to it; a triangle that is seen edge-on has no area and covers nothing. The
/// corners come in either order. This is the slot of exercise 13. (J. Pineda, A Parallel Algorithm for Polygon
/// Rasterization, SIGGRAPH 1988; J. F. Blinn, Hyperbolic Interpolation, IEEE CG&A 12(4), 1992.)
std::optional<double> drawn_depth(const std::array<DrawnCorner, 3>& corners, double x, double y);

}  // namespace raylab
