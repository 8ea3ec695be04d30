#pragma once

#include "raylab/geometry/affine.h"
#include "raylab/geometry/ray.h"
#include "raylab/geometry/shapes.h"

#include <compare>
#include <cstdint>
#include <optional>

// The lab's default answers to "does this ray hit this shape, and where?": a double filter with a proven error bound,
// double-doubles for the cases it leaves open, exact arithmetic for the few that these do. Every decision is the exact
// one, range (closed) included.

namespace raylab {

/// A hit of one shape, before it is known to be the nearest. The exact t lies within t_error of t.
struct Candidate {
    double t;
    double t_error;
    double u = 0, v = 0;  // triangles: weights of the second and third vertex
    Part part = Part::side;
};

/// Counts the decisions that were left to exact arithmetic.
struct DecisionCounts {
    std::uint64_t exact = 0;
};

/// The nearest hit inside ray.range of a surface seen from these sides (a tangent ray sees both); absent: none.
std::optional<Candidate> intersect(const Ray& ray, const Triangle& triangle, DecisionCounts& decisions,
                                   Sides sides = Sides::both);
std::optional<Candidate> intersect(const Ray& ray, const Sphere& sphere, DecisionCounts& decisions,
                                   Sides sides = Sides::both);

/// Any shape but a mesh, at its place (the exact image of the float shape under the float map).
std::optional<Candidate> intersect(const Ray& ray, const Shape& shape, const Affine& placement,
                                   DecisionCounts& decisions, Sides sides = Sides::both);

/// A triangle at its place.
std::optional<Candidate> intersect(const Ray& ray, const Triangle& triangle, const Affine& placement,
                                   DecisionCounts& decisions, Sides sides = Sides::both);

/// The same where they stand at the ray's time: their image under M + time R, in which nothing is rounded.
std::optional<Candidate> intersect(const Ray& ray, const Shape& shape, const Affine& placement, const Motion& motion,
                                   DecisionCounts& decisions, Sides sides = Sides::both);
std::optional<Candidate> intersect(const Ray& ray, const Triangle& triangle, const Affine& placement,
                                   const Motion& motion, DecisionCounts& decisions, Sides sides = Sides::both);

}  // namespace raylab
