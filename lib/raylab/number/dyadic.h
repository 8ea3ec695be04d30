#pragma once

#include "raylab/number/magnitude.h"
#include "raylab/number/sign.h"

#include <gmpxx.h>

namespace raylab {

/// mantissa * 2^exponent, both practically unbounded: sums, differences and products of floats and doubles are such
/// numbers, exactly. Unlike a rational number it needs no greatest common divisors, and it suffices for predicates.
class Dyadic {
public:
    Dyadic() = default;
    explicit Dyadic(double exact);  // the argument must be finite

    friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
    friend Dyadic operator-(const Dyadic& a, const Dyadic& b);
    friend Dyadic operator*(const Dyadic& a, const Dyadic& b);
    friend Dyadic operator-(const Dyadic& a);
    friend Sign sign(const Dyadic& a);

    /// The double nearest to numerator / denominator, which is not zero; infinite beyond the range of double.
    friend double quotient(const Dyadic& numerator, const Dyadic& denominator);

    /// The square root of a number that is not negative, rounded down to at least 120 bits.
    friend Dyadic sqrt(const Dyadic& a);

    mpq_class rational() const;

private:
    Dyadic(Sign sign, Magnitude mantissa, long exponent);
    explicit Dyadic(const mpz_class& mantissa, long exponent);

    static Dyadic sum(const Dyadic& a, const Dyadic& b, Sign sign_of_b);
    mpz_class absolute_mantissa() const;

    Sign sign_ = Sign::zero;
    long exponent_ = 0;
    Magnitude mantissa_;
};

}  // namespace raylab
