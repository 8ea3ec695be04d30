#pragma once

#include "raylab/geometry/vector.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace raylab::grading {

/// Seeded random numbers for cases: the same seed gives the same cases, with any standard library. They are a stream of
/// their own and no RandomSequence, because a seed's cases stay what they were: an answer once judged keeps its
/// verdict.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}

    double in(double low, double high) { return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53; }
    Vec3d point(double low, double high) {
        const double x = in(low, high);  // one at a time, because the compiler chooses the order of arguments
        const double y = in(low, high);
        return {x, y, in(low, high)};
    }
    Vec3d direction() {  // uniform on the unit sphere
        const double z = in(-1, 1);
        const double angle = in(0, 2 * std::numbers::pi);
        const double r = std::sqrt(1 - z * z);
        return {r * std::cos(angle), r * std::sin(angle), z};
    }

private:
    std::mt19937_64 engine_;
};

/// Rounds the coordinates to floats, which is what scenes contain.
inline Vec3d as_floats(const Vec3d& v) { return convert<double>(convert<float>(v)); }

}  // namespace raylab::grading
