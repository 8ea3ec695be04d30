#pragma once

#include "raylab/geometry/vector.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raylab {

/// The cone of directions around z up to an angle: where a sphere is seen from outside. It is known by 1 - cos of that
/// angle, which keeps all its digits for a tiny cone, where the cosine has lost them: 1 - cos = sin^2 / (1 + cos).
class SphereCone {
public:
    /// The cone in which a sphere is seen from a distance to its centre of at least its radius.
    static SphereCone around(double radius, double distance) {
        const double sine = std::min(1.0, radius / distance);
        const double squared_cosine = std::max(0.0, (distance - radius) * (distance + radius)) / (distance * distance);
        return SphereCone(sine * sine / (1 + std::sqrt(squared_cosine)));
    }

    explicit SphereCone(double one_minus_cosine) : height_(one_minus_cosine) {}

    double solid_angle() const { return 2 * std::numbers::pi * height_; }  // steradians; relative error 1e-15
    double pdf() const { return 1 / solid_angle(); }

    /// The direction of two numbers, uniform per steradian. Its angle from z has no cancellation either.
    Vec3d direction(double u, double v) const {
        const double below = u * height_;  // 1 - z
        const double across = std::sqrt(below * (2 - below)), turn = 2 * std::numbers::pi * v;
        return {across * std::cos(turn), across * std::sin(turn), 1 - below};
    }

private:
    double height_;  // of the cap that the cone cuts from the unit sphere
};

}  // namespace raylab
