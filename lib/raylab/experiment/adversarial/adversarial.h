#pragma once

#include "raylab/geometry/ray.h"
#include "raylab/geometry/shapes.h"

#include <cmath>
#include <random>
#include <vector>

// Rays and shapes made to be hard to decide: the accuracy tests and the differential tester draw from these.

namespace raylab::adversarial {

/// Random floats from a stream of its own: one a piece of work, so that results do not depend on threads. It is no
/// RandomSequence, because published counts (of wrong answers, of exact decisions) were made of these draws.
/// A call with two draws among its arguments gives other numbers on ARM, where GCC evaluates the first argument first,
/// than on x86.
class Draw {
public:
    explicit Draw(std::uint64_t seed) : bits_(seed) {}

    double number(double low, double high) { return low + (high - low) * std::generate_canonical<double, 53>(bits_); }
    float uniform(double low, double high) { return cast<float>(number(low, high)); }
    int integer(int low, int high) { return std::uniform_int_distribution(low, high)(bits_); }
    bool one_in(int n) { return integer(1, n) == 1; }

    Vec3f in_cube(double half) { return {uniform(-half, half), uniform(-half, half), uniform(-half, half)}; }
    Vec3f on_lattice(int low, int high) {
        const auto coordinate = [&] { return cast<float>(integer(low, high)); };
        return {coordinate(), coordinate(), coordinate()};
    }

    Vec3f lattice_direction(int half) {  // not zero
        const Vec3f d = on_lattice(-half, half);
        return d == Vec3f(0) ? Vec3f(0, 0, 1) : d;
    }

    /// Any exponent a float may have, subnormal ones too; often zero.
    float anything() {
        if (one_in(4)) return 0;
        const float mantissa = uniform(1, 2) * (one_in(2) ? 1.0f : -1.0f);
        return std::ldexp(mantissa, integer(-149, 126));
    }
    Vec3f anywhere() { return {anything(), anything(), anything()}; }
    Vec3f any_direction() {  // not zero
        const Vec3f d = anywhere();
        return d == Vec3f(0) ? Vec3f(1, 0, 0) : d;
    }

private:
    std::mt19937_64 bits_;
};

/// A ray from origin through a point that is rounded on the way: origin and direction are floats.
inline Ray through(const Vec3f& origin, const Vec3d& point) {
    const Vec3f direction = convert<float>(point - convert<double>(origin));
    return {origin, direction == Vec3f(0) ? Vec3f(0, 1, 0) : direction};
}

/// Ranges that make the ends matter: now and then an end at t, or one float beside it.
inline Interval<float> tight_range(Draw& draw, float t) {
    const float infinity = std::numeric_limits<float>::infinity();
    if (!std::isfinite(t)) return {0, infinity};
    const auto near_t = [&] {
        const int step = draw.integer(-1, 1);
        return step == 0 ? t : std::nextafter(t, step > 0 ? infinity : -infinity);
    };
    switch (draw.integer(0, 4)) {
        case 0:
            return {near_t(), infinity};
        case 1:
            return {0, near_t()};
        case 2:
            return {t, t};
        case 3:
            return {-infinity, near_t()};
        default:
            return {-infinity, infinity};
    }
}

inline Vec3f scaled(const Vec3f& v, float by) { return {v.x * by, v.y * by, v.z * by}; }

}  // namespace raylab::adversarial
