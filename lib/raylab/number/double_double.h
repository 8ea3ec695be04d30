#pragma once

#include <cmath>

namespace raylab {

/// A number as the unevaluated sum of two doubles, high being that sum rounded to double: 106 bits or more, in the
/// exponent range of double. Each operation costs some twenty operations on doubles. T. J. Dekker, A Floating-Point
/// Technique for Extending the Available Precision, Numerische Mathematik 18, 1971.
///
/// The error bounds of the operations, with u = 2^-53 and where nothing leaves the range of double:
///   a + b, a - b   |error| <= 3 u^2 / (1 - 4 u) |a + b|: Joldes, Muller & Popescu, Tight and Rigorous Error Bounds for
///                  Basic Building Blocks of Double-Word Arithmetic, ACM TOMS 44(2), 2017, of their algorithm 6
///   a * b          |error| <= 9 u^2 |a b|: leaving out the product of the low parts costs u^2, the roundings of two
///                  terms u of the product in size, of their sum, and of its sum with two_product's rest
///                  (1 + 1 + 2 + 3) u^2, and one u^2 more is more than all higher powers
/// Where both low parts are zero, sum and product are exact. Sums stay right where they underflow; a product errs by
/// up to 8 2^-1074 more where it lies below 2^-960 (two_product's share of it is 5: Ogita, Rump & Oishi, Accurate Sum
/// and Dot Product, SIAM J. Sci. Comput. 26(6), 2005). Overflow, and factors above 2^995, make high infinite or NaN.
struct DoubleDouble {
    double high = 0, low = 0;

    constexpr DoubleDouble() = default;
    constexpr explicit DoubleDouble(double exact) : high(exact) {}
    // |rest| must be at most half a unit in the last place.
    constexpr DoubleDouble(double rounded, double rest) : high(rounded), low(rest) {}
};

/// a + b, exactly. D. E. Knuth, The Art of Computer Programming 2, section 4.2.2, theorem B.
constexpr DoubleDouble two_sum(double a, double b) {
    const double sum = a + b;
    const double of_b = sum - a;
    return {sum, (a - (sum - of_b)) + (b - of_b)};
}

/// a + b, exactly, where |a| >= |b| or a is zero (Dekker).
constexpr DoubleDouble fast_two_sum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// a b, exactly: Veltkamp's split makes two halves of 26 bits, whose products are exact (Dekker). A fused multiply-add
/// is not used, because not every processor has it.
constexpr DoubleDouble two_product(double a, double b) {
    struct Halves {
        double high, low;
    };
    const auto split = [](double x) -> Halves {
        const double large = 0x1.0000002p27 * x;  // 2^27 + 1
        const double high = large - (large - x);
        return {high, x - high};
    };
    const double product = a * b;
    const Halves p = split(a), q = split(b);
    return {product, ((p.high * q.high - product) + p.high * q.low + p.low * q.high) + p.low * q.low};
}

constexpr DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }

constexpr DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble high = two_sum(a.high, b.high), low = two_sum(a.low, b.low);
    const DoubleDouble sum = fast_two_sum(high.high, high.low + low.high);
    return fast_two_sum(sum.high, sum.low + low.low);
}

constexpr DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }

constexpr DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble product = two_product(a.high, b.high);
    return fast_two_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

}  // namespace raylab
