#include "raylab/number/dyadic.h"

#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace raylab {

namespace {

mpz_class shifted_left(const mpz_class& a, long by) {
    mpz_class result;
    mpz_mul_2exp(result.get_mpz_t(), a.get_mpz_t(), static_cast<mp_bitcnt_t>(by));
    return result;
}

long bit_length(const mpz_class& a) { return static_cast<long>(mpz_sizeinbase(a.get_mpz_t(), 2)); }

// The double nearest to (a + some 0 <= fraction < 1) * 2^exponent; `inexact`: the fraction is not zero. a > 0.
double nearest_double(mpz_class a, bool inexact, long exponent) {
    const long excess = bit_length(a) - 64;
    if (excess > 0) {
        inexact = inexact || mpz_scan1(a.get_mpz_t(), 0) < static_cast<mp_bitcnt_t>(excess);
        mpz_tdiv_q_2exp(a.get_mpz_t(), a.get_mpz_t(), static_cast<mp_bitcnt_t>(excess));
        exponent += excess;
    }
    std::uint64_t bits = 0;
    mpz_export(&bits, nullptr, 1, sizeof bits, 0, 0, a.get_mpz_t());
    // The lowest of 64 bits stands for all that was cut off: rounding to 53 bits sees the true remainder.
    if (inexact) bits |= 1;
    const long clamped = exponent > 4000 ? 4000 : exponent < -4000 ? -4000 : exponent;
    return std::ldexp(static_cast<double>(bits), static_cast<int>(clamped));
}

}  // namespace

Dyadic::Dyadic(double exact) {
    assert(std::isfinite(exact));
    if (exact == 0) return;
    int exponent = 0;
    const auto whole = static_cast<std::int64_t>(std::ldexp(std::frexp(exact, &exponent), 53));
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(whole));
    mantissa_ = static_cast<long>(whole >> zeros);  // short mantissas keep the products short
    exponent_ = exponent - 53 + zeros;
}

Dyadic operator+(const Dyadic& a, const Dyadic& b) {
    if (sgn(a.mantissa_) == 0) return b;
    if (sgn(b.mantissa_) == 0) return a;
    if (a.exponent_ == b.exponent_) return {a.mantissa_ + b.mantissa_, a.exponent_};
    if (a.exponent_ > b.exponent_) {
        return {shifted_left(a.mantissa_, a.exponent_ - b.exponent_) + b.mantissa_, b.exponent_};
    }
    return {a.mantissa_ + shifted_left(b.mantissa_, b.exponent_ - a.exponent_), a.exponent_};
}

Dyadic operator-(const Dyadic& a) { return {-a.mantissa_, a.exponent_}; }

Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }

Dyadic operator*(const Dyadic& a, const Dyadic& b) { return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_}; }

Sign sign(const Dyadic& a) { return static_cast<Sign>(sgn(a.mantissa_)); }

double quotient(const Dyadic& numerator, const Dyadic& denominator) {
    const int sign = sgn(numerator.mantissa_) * sgn(denominator.mantissa_);
    assert(sgn(denominator.mantissa_) != 0);
    if (sign == 0) return 0;
    mpz_class n = abs(numerator.mantissa_);
    const mpz_class d = abs(denominator.mantissa_);
    long exponent = numerator.exponent_ - denominator.exponent_;
    const long missing = 66 - (bit_length(n) - bit_length(d));  // so many more bits and the quotient has 66 or 67
    if (missing > 0) {
        n = shifted_left(n, missing);
        exponent -= missing;
    }
    mpz_class whole, rest;
    mpz_tdiv_qr(whole.get_mpz_t(), rest.get_mpz_t(), n.get_mpz_t(), d.get_mpz_t());
    return sign * nearest_double(std::move(whole), sgn(rest) != 0, exponent);
}

Dyadic sqrt(const Dyadic& a) {
    assert(sgn(a.mantissa_) >= 0);
    if (sgn(a.mantissa_) == 0) return {};
    long shift = std::max(0L, 242 - bit_length(a.mantissa_));
    if ((a.exponent_ - shift) % 2 != 0) ++shift;
    return {sqrt(shifted_left(a.mantissa_, shift)), (a.exponent_ - shift) / 2};
}

mpq_class Dyadic::rational() const {
    mpq_class result(mantissa_);
    if (exponent_ >= 0) {
        mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent_));
    } else {
        mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent_));
    }
    return result;
}

}  // namespace raylab
