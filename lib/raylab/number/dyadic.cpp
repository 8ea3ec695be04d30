#include "raylab/number/dyadic.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace raylab {

namespace {

// a * 2^by, with leading zeros for the sum with a number of `other` limbs.
Magnitude shifted_left(const Magnitude& a, long by, std::size_t other) {
    const auto whole = static_cast<std::size_t>(by) / GMP_NUMB_BITS;
    const auto bits = static_cast<unsigned>(by % GMP_NUMB_BITS);
    Magnitude result(std::max(a.size() + whole + 1, other) + 1);
    mp_limb_t* const limbs = result.limbs();
    std::fill_n(limbs, whole, 0);
    std::fill(limbs + whole + a.size(), limbs + result.size(), 0);
    if (bits == 0) {
        std::copy_n(a.limbs(), a.size(), limbs + whole);
    } else {
        limbs[whole + a.size()] = mpn_lshift(limbs + whole, a.limbs(), a.length(), bits);
    }
    return result;
}

// add() and subtract() accept a first argument with leading zeros.
void add(Magnitude& to, const Magnitude& other) {
    mpn_add(to.limbs(), to.limbs(), to.length(), other.limbs(), other.length());
}

// Stores |from - other| and returns the sign of the difference.
Sign subtract(Magnitude& from, const Magnitude& other) {
    from.trim();
    const bool larger = from.size() != other.size() ? from.size() > other.size()
                                                    : mpn_cmp(from.limbs(), other.limbs(), from.length()) >= 0;
    if (larger) {
        mpn_sub(from.limbs(), from.limbs(), from.length(), other.limbs(), other.length());
        return Sign::positive;
    }
    Magnitude difference(other.size());
    mpn_sub(difference.limbs(), other.limbs(), other.length(), from.limbs(), from.length());
    from = std::move(difference);
    return Sign::negative;
}

long bit_length(const mpz_class& a) { return static_cast<long>(mpz_sizeinbase(a.get_mpz_t(), 2)); }

// The double nearest to (a + some fraction) * 2^exponent, where 0 <= fraction < 1 and `inexact` means that the fraction
// is not zero; a > 0.
double nearest_double(mpz_class a, bool inexact, long exponent) {
    const long excess = bit_length(a) - 64;
    if (excess > 0) {
        inexact = inexact || mpz_scan1(a.get_mpz_t(), 0) < static_cast<mp_bitcnt_t>(excess);
        mpz_tdiv_q_2exp(a.get_mpz_t(), a.get_mpz_t(), static_cast<mp_bitcnt_t>(excess));
        exponent += excess;
    }
    std::uint64_t bits = 0;
    mpz_export(&bits, nullptr, 1, sizeof bits, 0, 0, a.get_mpz_t());
    // The lowest of 64 bits stands for all bits that were cut off, so that rounding to 53 bits is correct.
    if (inexact) bits |= 1;
    const long clamped = exponent > 4000 ? 4000 : exponent < -4000 ? -4000 : exponent;
    return std::ldexp(static_cast<double>(bits), static_cast<int>(clamped));
}

}  // namespace

Dyadic::Dyadic(Sign sign, Magnitude mantissa, long exponent)
    : sign_(sign), exponent_(exponent), mantissa_(std::move(mantissa)) {
    mantissa_.trim();
    if (mantissa_.size() == 0) *this = {};
}

Dyadic::Dyadic(const mpz_class& mantissa, long exponent)
    : exponent_(exponent), mantissa_(mpz_size(mantissa.get_mpz_t())) {
    sign_ = static_cast<Sign>(sgn(mantissa));
    std::copy_n(mpz_limbs_read(mantissa.get_mpz_t()), mantissa_.size(), mantissa_.limbs());
}

Dyadic::Dyadic(double exact) {
    assert(std::isfinite(exact));
    if (exact == 0) return;
    int exponent = 0;
    const auto whole = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::abs(exact), &exponent), 53));
    const int zeros = std::countr_zero(whole);
    sign_ = exact < 0 ? Sign::negative : Sign::positive;
    mantissa_ = Magnitude(1);
    mantissa_.limbs()[0] = whole >> zeros;  // short mantissas keep the products short
    exponent_ = exponent - 53 + zeros;
}

Dyadic Dyadic::sum(const Dyadic& a, const Dyadic& b, Sign sign_of_b) {
    if (sign_of_b == Sign::zero) return a;
    if (a.sign_ == Sign::zero) return {sign_of_b, b.mantissa_, b.exponent_};
    const bool a_ends_higher = a.exponent_ >= b.exponent_;
    const Dyadic &high = a_ends_higher ? a : b, &low = a_ends_higher ? b : a;
    Magnitude both = shifted_left(high.mantissa_, high.exponent_ - low.exponent_, low.mantissa_.size());
    if (a.sign_ == sign_of_b) {
        add(both, low.mantissa_);
        return {a.sign_, std::move(both), low.exponent_};
    }
    const Sign larger = subtract(both, low.mantissa_);
    return {(a_ends_higher ? a.sign_ : sign_of_b) * larger, std::move(both), low.exponent_};
}

Dyadic operator+(const Dyadic& a, const Dyadic& b) { return Dyadic::sum(a, b, b.sign_); }

Dyadic operator-(const Dyadic& a, const Dyadic& b) { return Dyadic::sum(a, b, -b.sign_); }

Dyadic operator-(const Dyadic& a) { return {-a.sign_, a.mantissa_, a.exponent_}; }

Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    if (a.sign_ == Sign::zero || b.sign_ == Sign::zero) return {};
    const bool a_is_longer = a.mantissa_.size() >= b.mantissa_.size();
    const Magnitude &longer = a_is_longer ? a.mantissa_ : b.mantissa_, &other = a_is_longer ? b.mantissa_ : a.mantissa_;
    Magnitude product(longer.size() + other.size());
    mpn_mul(product.limbs(), longer.limbs(), longer.length(), other.limbs(), other.length());
    return {a.sign_ * b.sign_, std::move(product), a.exponent_ + b.exponent_};
}

Sign sign(const Dyadic& a) { return a.sign_; }

mpz_class Dyadic::absolute_mantissa() const {
    mpz_t seen;
    return mpz_class(mpz_roinit_n(seen, mantissa_.limbs(), mantissa_.length()));
}

double quotient(const Dyadic& numerator, const Dyadic& denominator) {
    const Sign sign = numerator.sign_ * denominator.sign_;
    assert(denominator.sign_ != Sign::zero);
    if (sign == Sign::zero) return 0;
    mpz_class n = numerator.absolute_mantissa();
    const mpz_class d = denominator.absolute_mantissa();
    long exponent = numerator.exponent_ - denominator.exponent_;
    const long missing = 66 - (bit_length(n) - bit_length(d));  // with this many more bits the quotient has 66 or 67
    if (missing > 0) {
        n <<= static_cast<mp_bitcnt_t>(missing);
        exponent -= missing;
    }
    mpz_class whole, rest;
    mpz_tdiv_qr(whole.get_mpz_t(), rest.get_mpz_t(), n.get_mpz_t(), d.get_mpz_t());
    return static_cast<int>(sign) * nearest_double(std::move(whole), sgn(rest) != 0, exponent);
}

Dyadic sqrt(const Dyadic& a) {
    assert(a.sign_ != Sign::negative);
    if (a.sign_ == Sign::zero) return {};
    const mpz_class mantissa = a.absolute_mantissa();
    long shift = std::max(0L, 242 - bit_length(mantissa));
    if ((a.exponent_ - shift) % 2 != 0) ++shift;
    return Dyadic(sqrt(mpz_class(mantissa << static_cast<mp_bitcnt_t>(shift))), (a.exponent_ - shift) / 2);
}

mpq_class Dyadic::rational() const {
    mpq_class result(static_cast<int>(sign_) * absolute_mantissa());
    if (exponent_ >= 0) {
        mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent_));
    } else {
        mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent_));
    }
    return result;
}

}  // namespace raylab
