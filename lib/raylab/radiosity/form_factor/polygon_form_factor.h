#pragma once

#include "raylab/geometry/vector.h"

#include <span>

namespace raylab {

/// Area times form factor of two convex polygons in full view of one another; by reciprocity it is the same from either
/// side. Only what is in front of the other's plane counts. Polygons may touch or share edges.
///
/// The double contour integral in closed form, with dilogarithms (Schroeder and Hanrahan, "On the Form Factor between
/// Two Polygons", SIGGRAPH 93), and Gauss points in its place where it would cancel: around a polygon that is small
/// beside its distance the integrand is smooth. A polygon that is large beside the other is halved until one of the two
/// applies. The relative error is about 1e-13.
/// Weak spots: polygons that both see the other edge-on, and near strips: one of width w and length 1 loses 1e-16/w.
double exchange_area(std::span<const Vec3d> from, std::span<const Vec3d> to);  // m^2

/// The form factor from one polygon to another in full view.
double polygon_form_factor(std::span<const Vec3d> from, std::span<const Vec3d> to);

}  // namespace raylab
