#pragma once

#include "raylab/number/enclosure.h"

#include <cmath>

namespace raylab {

/// A number as doubles compute it, with the magnitude of what was added up for it: the same sums and products of absolute
/// values. What a predicate is asked in first: it costs twice what doubles do, and nearly always knows the sign.
///
/// After n roundings the one differs from the exact value by less than ((1 + u)^n - 1) times the exact other (Higham,
/// Accuracy and Stability of Numerical Algorithms, section 3.1; the factors of a product bring their roundings along), and
/// (1 - u)^n bounds the rounding of that one. Predicates take fewer than `most_roundings` (tests/geometry/roundings.cpp
/// counts them). What underflows, 2^-1075 of a product, is less than u times `least`, which every product's magnitude
/// carries. Overflow makes a magnitude infinite or NaN, and every comparison with it fails.
class Estimate {
public:
    static constexpr int most_roundings = 120;

    constexpr Estimate() = default;
    constexpr explicit Estimate(double exact) : value_(exact), magnitude_(exact < 0 ? -exact : exact) {}

    constexpr double value() const { return value_; }

    /// Where the number lies surely.
    Enclosure enclosed() const { return {value_, error()}; }

    friend Estimate operator-(const Estimate& a) { return {-a.value_, a.magnitude_}; }
    friend Estimate operator+(const Estimate& a, const Estimate& b) {
        return {a.value_ + b.value_, a.magnitude_ + b.magnitude_};
    }
    friend Estimate operator-(const Estimate& a, const Estimate& b) {
        return {a.value_ - b.value_, a.magnitude_ + b.magnitude_};
    }
    friend Estimate operator*(const Estimate& a, const Estimate& b) {
        return {a.value_ * b.value_, a.magnitude_ * b.magnitude_ + least};
    }

    friend std::optional<Sign> sign(const Estimate& a) {
        if (a.value_ > a.error()) return Sign::positive;
        if (a.value_ < -a.error()) return Sign::negative;
        return std::nullopt;  // zero too: what it is made of may have underflowed
    }

private:
    static constexpr double relative = 0x1p-46;  // 128 u: the rest is for the bounds' own roundings
    static constexpr double least = 0x1p-1000;

    constexpr Estimate(double value, double magnitude) : value_(value), magnitude_(magnitude) {}
    double error() const { return relative * magnitude_; }

    double value_ = 0;
    double magnitude_ = 0;
};

}  // namespace raylab
