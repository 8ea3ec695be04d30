#include "raylab/geometry/oracle/oracle_cgal.h"

#include <array>
#include <bit>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <utility>

namespace raylab::oracle {

namespace {

std::strong_ordering ordering(CGAL::Comparison_result result) { return static_cast<int>(result) <=> 0; }

/// The floating-point numbers of a type, counted through from zero: place n + 1 is the next above place n, and the
/// infinities stand at both ends.
template <Real T>
struct Places {
    using Bits = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;

    static Bits of(T value) {
        const Bits magnitude = std::bit_cast<Bits>(std::abs(value));
        return value < 0 ? -magnitude : magnitude;
    }
    static T at(Bits place) {
        const T magnitude = std::bit_cast<T>(place < 0 ? -place : place);
        return place < 0 ? -magnitude : magnitude;
    }
    static constexpr Bits end = std::bit_cast<Bits>(std::numeric_limits<T>::infinity());
};

/// Near x, mostly: a first guess. Where the two terms cancel, their product with the conjugate does not.
double guess(const Root& x) {
    const double a0 = CGAL::to_double(x.a0());
    if (!x.is_extended()) return a0;
    const double a1_root = CGAL::to_double(x.a1()) * std::sqrt(CGAL::to_double(x.root()));
    if ((a0 < 0) == (a1_root < 0)) return a0 + a1_root;
    return CGAL::to_double(x.a0() * x.a0() - x.a1() * x.a1() * x.root()) / (a0 - a1_root);
}

/// The place of the largest T at or below x: strides that double away from the guess, then halves.
template <Real T>
typename Places<T>::Bits floor_place(const Root& x) {
    using P = Places<T>;
    using Bits = typename P::Bits;
    const T start = cast<T>(guess(x));
    Bits low = std::isnan(start) ? 0 : P::of(start);
    Bits high = low;
    const auto longer = [](Bits stride) { return stride < P::end / 2 ? stride * 2 : stride; };
    for (Bits stride = 1; low > -P::end && compare(x, cast<double>(P::at(low))) < 0; stride = longer(stride)) {
        high = low;
        low = low < stride - P::end ? -P::end : low - stride;
    }
    for (Bits stride = 1; high < P::end && compare(x, cast<double>(P::at(high))) >= 0; stride = longer(stride)) {
        low = high;
        high = high > P::end - stride ? P::end : high + stride;
    }
    while (high - low > 1) {
        const Bits middle = low + (high - low) / 2;
        (compare(x, cast<double>(P::at(middle))) < 0 ? high : low) = middle;
    }
    return low;
}

/// A T as an exact number; infinity stands for the first power of two that is too large, as IEEE 754 rounds.
template <Real T>
Rational exact_or_overflow(T value) {
    if (std::isfinite(value)) return exact(cast<double>(value));
    const T largest = std::numeric_limits<T>::max();
    const Rational beyond = exact(cast<double>(largest)) + exact(cast<double>(largest - std::nextafter(largest, T(0))));
    return value < 0 ? Rational(-beyond) : beyond;
}

template <Real T>
T nearest_to(const Root& x) {
    using P = Places<T>;
    const auto low = floor_place<T>(x);
    if (low == P::end) return P::at(low);
    const Rational middle = (exact_or_overflow(P::at(low)) + exact_or_overflow(P::at(low + 1))) / 2;
    const auto side = x.compare(middle);
    const bool low_is_even = low % 2 == 0;
    return side == CGAL::SMALLER || (side == CGAL::EQUAL && low_is_even) ? P::at(low) : P::at(low + 1);
}

template <Real T>
double error_of(T t, const Root& x) {
    if (!std::isfinite(t)) return std::numeric_limits<double>::infinity();
    const T nearest = std::abs(nearest_to<T>(x));
    if (!std::isfinite(nearest)) return std::numeric_limits<double>::infinity();
    const T above = std::nextafter(nearest, std::numeric_limits<T>::infinity());
    const Rational ulp = exact_or_overflow(above) - exact(cast<double>(nearest));
    return nearest_double(CGAL::abs(Root(x - exact(cast<double>(t)))) / ulp);
}

std::string decimal(double value) {
    std::array<char, 32> text;
    return {text.data(), std::to_chars(text.begin(), text.end(), value).ptr};
}

template <class Number>
std::string written(const Number& x) {
    return (std::ostringstream() << x).str();
}

/// "3/4", "-2".
std::string fraction_of(const Rational& x) { return x.denominator() == 1 ? written(x.numerator()) : written(x); }

/// " + 3", " - 3", " + 3 t", " + t": one term of a sum; nothing where it is zero.
std::string term(const CGAL::Gmpz& coefficient, const std::string& power) {
    if (coefficient == 0) return "";
    const std::string sign = coefficient < 0 ? " - " : " + ";
    const std::string size = written(CGAL::abs(coefficient));
    if (power.empty()) return sign + size;
    return sign + (size == "1" ? "" : size + " ") + power;
}

/// "2 t^2 - 4 t + 1", in whole numbers without a common divisor, of which x is a root.
std::string equation_of(const Root& x) {
    const Rational sum = 2 * x.a0();
    const Rational product = x.a0() * x.a0() - x.a1() * x.a1() * x.root();
    const CGAL::Gmpz scale =
        sum.denominator() *
        CGAL::integral_division(product.denominator(), CGAL::gcd(sum.denominator(), product.denominator()));
    const CGAL::Gmpz linear = (sum * Rational(scale)).numerator();
    const CGAL::Gmpz constant = (product * Rational(scale)).numerator();
    return (term(scale, "t^2") + term(-linear, "t") + term(constant, "")).substr(3);
}

}  // namespace

std::strong_ordering compare(const Root& x, double y) {
    assert(!std::isnan(y));
    if (std::isinf(y)) return y < 0 ? std::strong_ordering::greater : std::strong_ordering::less;
    return ordering(x.compare(exact(y)));
}

double nearest_double(const Root& x) { return nearest_to<double>(x); }

ExactT::ExactT(std::shared_ptr<const Value> value) : value_(std::move(value)) { assert(value_); }

std::strong_ordering ExactT::compare(const ExactT& other) const { return ordering(value_->t.compare(other.value_->t)); }

std::strong_ordering ExactT::compare(double other) const { return oracle::compare(value_->t, other); }

double ExactT::nearest() const { return nearest_double(value_->t); }

double ExactT::error_in_ulp(float t) const { return error_of(t, value_->t); }

double ExactT::error_in_ulp(double t) const { return error_of(t, value_->t); }

std::string ExactT::to_string() const {
    constexpr std::size_t longest = 60;  // of an exact number that still says something to a reader
    const Root& t = value_->t;
    const std::string number = decimal(nearest());
    if (!t.is_extended()) {
        const std::string fraction = fraction_of(t.a0());
        if (fraction == number) return number;
        if (fraction.size() <= longest) return number + " (" + fraction + ")";
        return number + " (a fraction of " + std::to_string(fraction.size() - 1) + " digits)";
    }
    const std::string which = t.a1() < 0 ? "smaller" : "larger";
    const std::string equation = equation_of(t);
    if (equation.size() <= longest) return number + " (" + which + " root of " + equation + ")";
    return number + " (" + which + " root of a quadratic)";
}

}  // namespace raylab::oracle
