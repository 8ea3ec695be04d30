#pragma once

#include "raylab/number/enclosure.h"

#include <cmath>

namespace raylab {

/// A number computed in doubles, with its magnitude: the same sums and products of absolute values. Predicates are
/// evaluated in this type first: it costs twice as much as doubles, and nearly always decides the sign.
///
/// After n roundings the number differs from the exact value by less than ((1 + u)^n - 1) times the exact magnitude
/// (Higham, Accuracy and Stability of Numerical Algorithms, section 3.1; the roundings of a product's factors are
/// counted, too), and (1 - u)^n bounds the rounding of the magnitude. Predicates take fewer than `max_roundings`
/// (tests/geometry/roundings.cpp counts them). Underflow, of 2^-1075 in a product, is less than u times `least`, which
/// every product's magnitude includes. Overflow makes a magnitude infinite or NaN, and every comparison with it fails.
class Estimate {
public:
    static constexpr int max_roundings = 120;

    constexpr Estimate() = default;
    constexpr explicit Estimate(double exact) : value_(exact), magnitude_(exact < 0 ? -exact : exact) {}

    constexpr double value() const { return value_; }

    /// An interval that surely contains the exact number.
    Enclosure enclosed() const { return {value_, error()}; }

    friend Estimate operator-(const Estimate& a) { return {-a.value_, a.magnitude_}; }
    friend Estimate operator+(const Estimate& a, const Estimate& b) {
        return {a.value_ + b.value_, a.magnitude_ + b.magnitude_};
    }
    friend Estimate operator-(const Estimate& a, const Estimate& b) {
        return {a.value_ - b.value_, a.magnitude_ + b.magnitude_};
    }
    friend Estimate operator*(const Estimate& a, const Estimate& b) {
        return {a.value_ * b.value_, a.magnitude_ * b.magnitude_ + smallest};
    }

    friend std::optional<Sign> sign(const Estimate& a) {
        if (a.value_ > a.error()) return Sign::positive;
        if (a.value_ < -a.error()) return Sign::negative;
        return std::nullopt;  // also for zero, because what it was computed from may have underflowed
    }

private:
    static constexpr double relative = 0x1p-46;  // 128 u: more than the roundings need, for those of the bound itself
    static constexpr double smallest = 0x1p-1000;

    constexpr Estimate(double value, double magnitude) : value_(value), magnitude_(magnitude) {}
    double error() const { return relative * magnitude_; }

    double value_ = 0;
    double magnitude_ = 0;
};

}  // namespace raylab
