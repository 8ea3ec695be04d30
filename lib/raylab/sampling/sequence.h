#pragma once

#include "raylab/geometry/vector.h"
#include "raylab/sampling/random.h"

#include <cmath>

namespace raylab {

/// The random numbers of one place, one after another: its dimensions 0, 1, 2, ... It is a value: a copy continues from
/// where it was copied.
class RandomSequence {
public:
    RandomSequence(std::uint64_t seed, std::uint64_t pixel, std::uint64_t sample = 0)
        : place_{.seed = seed, .pixel = pixel, .sample = sample} {}

    /// A number in [0, 1).
    double next() {
        const double number = random_number(place_);
        ++place_.dimension;
        return number;
    }

    /// A number in [low, high).
    double between(double low, double high) { return low + (high - low) * next(); }

    /// One of low, low + 1, ..., high.
    int whole(int low, int high) { return low + static_cast<int>(next() * (high - low + 1)); }

    /// A point of the unit sphere, uniform in area (Marsaglia, "Choosing a Point from the Surface of a Sphere", 1972).
    /// It needs no sine or cosine, whose last bits depend on the machine.
    Vec3d unit_vector() {
        const double x = between(-1, 1);
        const double y = between(-1, 1);
        const double squared = x * x + y * y;
        if (squared >= 1) return unit_vector();
        const double scale = 2 * std::sqrt(1 - squared);
        return {scale * x, scale * y, 1 - 2 * squared};
    }

    /// A unit vector perpendicular to an axis.
    Vec3d unit_vector_across(const Vec3d& axis) { return glm::normalize(cross(axis, unit_vector())); }

    /// A point of the cube [-1, 1]^3.
    Vec3d in_cube() {
        const double x = between(-1, 1);
        const double y = between(-1, 1);
        return {x, y, between(-1, 1)};
    }

private:
    RandomPlace place_;
};

}  // namespace raylab
