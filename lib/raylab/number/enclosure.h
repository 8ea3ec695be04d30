#pragma once

#include "raylab/number/sign.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace raylab {

/// An interval that surely contains a number: |x - middle| <= radius. This is interval arithmetic by middle and radius
/// (Rump, Fast and parallel interval arithmetic, BIT 39, 1999) in rounding to nearest, so that the rounding mode is
/// never switched.
///
/// Each operation adds to the radius a bound of its own rounding error. In doubles, with u = 2^-53 and h = 2^-1074: a
/// sum differs from its rounding m by at most u|m| (nothing where it underflows: such sums are exact), a product or
/// quotient by at most u|m| + h/2. Taking 2u|m| and whole multiples of h leaves room for the rounding of the radius's
/// own terms, each of at most a few u relative (the last factor) and h/2 absolute. Overflow makes the radius infinite
/// or NaN, so that no sign is known any more; every comparison is written to fail for NaN.
class Enclosure {
public:
    constexpr Enclosure() = default;
    constexpr explicit Enclosure(double exact) : middle_(exact) {}
    constexpr Enclosure(double middle, double radius) : middle_(middle), radius_(radius) {}

    constexpr double middle() const { return middle_; }
    constexpr double radius() const { return radius_; }

    /// No number of the interval lies below lower() or above upper().
    double lower() const { return -(-*this).upper(); }
    double upper() const {
        const double sum = middle_ + radius_;
        return sum + (rounding * std::abs(sum) + smallest);
    }

    friend Enclosure operator-(const Enclosure& a) { return {-a.middle_, a.radius_}; }

    friend Enclosure operator+(const Enclosure& a, const Enclosure& b) {
        const double middle = a.middle_ + b.middle_;
        if (a.radius_ == 0 && b.radius_ == 0 && middle - a.middle_ == b.middle_ && middle - b.middle_ == a.middle_) {
            // The difference from the larger operand is exact (Dekker 1971), so nothing was rounded.
            return Enclosure(middle);
        }
        return {middle, (a.radius_ + b.radius_ + rounding * std::abs(middle)) * outward};
    }

    friend Enclosure operator-(const Enclosure& a, const Enclosure& b) { return a + -b; }

    friend Enclosure operator*(const Enclosure& a, const Enclosure& b) {
        if (a.is_zero() || b.is_zero()) return {};
        const double middle = a.middle_ * b.middle_;
        const double spread = std::abs(a.middle_) * b.radius_ + a.radius_ * (std::abs(b.middle_) + b.radius_);
        return {middle, (spread + (rounding * std::abs(middle) + 4 * smallest)) * outward};
    }

    friend Enclosure operator/(const Enclosure& a, const Enclosure& b) {
        const double room = std::abs(b.middle_) - b.radius_;
        if (!(room > 0)) return unknown();
        const double middle = a.middle_ / b.middle_;
        // |x/y - m| <= (|x - a| + |m| |y - b|) / |y|
        const double spread = (a.radius_ + (std::abs(middle) + smallest) * b.radius_ + 4 * smallest) / room;
        return {middle, (spread + (rounding * std::abs(middle) + 4 * smallest)) * outward};
    }

    /// The square root of a number that is known not to be negative, even if a part of the interval is.
    friend Enclosure sqrt(const Enclosure& a) {
        if (a.is_zero()) return {};
        if (!(a.middle_ > 0)) {  // the number lies in [0, middle + radius]
            const double half = std::sqrt(std::max(a.upper(), 0.0)) / 2;
            return {half, half * (1 + 8 * rounding)};
        }
        const double middle = std::sqrt(a.middle_);
        // |sqrt x - sqrt m| = |x - m| / (sqrt x + sqrt m)
        return {middle, (a.radius_ / middle + (rounding * middle + smallest)) * outward};
    }

    friend std::optional<Sign> sign(const Enclosure& a) {
        if (a.middle_ > a.radius_) return Sign::positive;
        if (a.middle_ < -a.radius_) return Sign::negative;
        if (a.is_zero()) return Sign::zero;
        return std::nullopt;
    }

private:
    static constexpr double rounding = 2 * unit_roundoff<double>;
    static constexpr double smallest = std::numeric_limits<double>::denorm_min();
    static constexpr double outward = 1 + 8 * rounding;

    bool is_zero() const { return middle_ == 0 && radius_ == 0; }
    static Enclosure unknown() { return {0, std::numeric_limits<double>::infinity()}; }

    double middle_ = 0;
    double radius_ = 0;
};

}  // namespace raylab
