#pragma once

#include "raylab/number/double_double.h"
#include "raylab/number/enclosure.h"

namespace raylab {

/// An enclosure whose middle is a double-double. Predicates are evaluated in it where doubles do not decide, before
/// exact numbers, which take ten times as long. Its radius grows as Enclosure's does, by the error bounds of
/// DoubleDouble; where nothing was rounded it stays zero, so that small whole numbers have exact signs, including zero.
class FineEnclosure {
public:
    constexpr FineEnclosure() = default;
    constexpr explicit FineEnclosure(double exact) : middle_(exact) {}

    constexpr const DoubleDouble& middle() const { return middle_; }
    constexpr double radius() const { return radius_; }

    /// The same interval, slightly wider, with a double as its middle.
    Enclosure rounded() const { return {middle_.high, (radius_ + std::abs(middle_.low)) * outward}; }

    /// A double near a / b.
    friend double quotient(const FineEnclosure& a, const FineEnclosure& b) { return a.middle_.high / b.middle_.high; }

    friend FineEnclosure operator-(const FineEnclosure& a) { return {-a.middle_, a.radius_}; }

    friend FineEnclosure operator+(const FineEnclosure& a, const FineEnclosure& b) {
        const DoubleDouble middle = a.middle_ + b.middle_;
        // 3 u^2 / (1 - 4 u) and the rounding of this bound. Below 2^-968 a sum's error is a whole multiple of 2^-1074,
        // and less than one where the bound underflows.
        const double error = are_short(a, b) ? 0 : 4 * u2 * std::abs(middle.high);
        return {middle, (a.radius_ + b.radius_ + error) * outward};
    }

    friend FineEnclosure operator-(const FineEnclosure& a, const FineEnclosure& b) { return a + -b; }

    friend FineEnclosure operator*(const FineEnclosure& a, const FineEnclosure& b) {
        if (a.is_zero() || b.is_zero()) return {};
        const DoubleDouble middle = a.middle_ * b.middle_;
        const double size = std::abs(middle.high);
        const double of_a = std::abs(a.middle_.high), of_b = std::abs(b.middle_.high);
        const double spread = of_a * b.radius_ + a.radius_ * (of_b + b.radius_);
        const bool exact = are_short(a, b) && size > 0x1p-960;
        // 9 u^2 and 8 times 2^-1074, doubled for the roundings here.
        return {middle, (spread + (exact ? 0 : 16 * u2 * size + (size > 0x1p-900 ? 0 : 16 * smallest))) * outward};
    }

    friend std::optional<Sign> sign(const FineEnclosure& a) {
        // high stands for high + low, which is smaller by up to one part in 2^53.
        const double reach = a.radius_ * outward;
        if (a.middle_.high > reach) return Sign::positive;
        if (a.middle_.high < -reach) return Sign::negative;
        if (a.is_zero()) return Sign::zero;
        return std::nullopt;
    }

private:
    static constexpr double u2 = unit_roundoff<double> * unit_roundoff<double>;
    static constexpr double smallest = std::numeric_limits<double>::denorm_min();
    static constexpr double outward = 1 + 16 * unit_roundoff<double>;

    constexpr FineEnclosure(const DoubleDouble& middle, double radius) : middle_(middle), radius_(radius) {}

    bool is_zero() const { return middle_.high == 0 && radius_ == 0; }
    static bool are_short(const FineEnclosure& a, const FineEnclosure& b) {
        return a.middle_.low == 0 && b.middle_.low == 0;
    }

    DoubleDouble middle_;
    double radius_ = 0;
};

}  // namespace raylab
