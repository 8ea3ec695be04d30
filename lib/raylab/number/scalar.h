#pragma once

#include "raylab/number/ieee_754.h"

#include <concepts>
#include <limits>

namespace raylab {

/// Enough for predicates that never divide: float, double, long double, Enclosure, Rational.
template <class T>
concept Scalar = requires(T a, T b) {
    T(1.0);
    { a + b } -> std::convertible_to<T>;
    { a - b } -> std::convertible_to<T>;
    { a* b } -> std::convertible_to<T>;
    { -a } -> std::convertible_to<T>;
};

/// A machine number, ordered, with division and square root: what the methods of the literature compute in.
template <class T>
concept Real = Scalar<T> && std::floating_point<T>;

/// The relative error of one rounded operation in T: 2^-24 for float, 2^-53 for double.
template <Real T>
inline constexpr T unit_roundoff = std::numeric_limits<T>::epsilon() / 2;

/// A machine number's name, as tables and charts have it.
template <Real T>
inline constexpr const char* number_name = "long double";
template <>
inline constexpr const char* number_name<double> = "double";
template <>
inline constexpr const char* number_name<float> = "float";

/// A narrowing conversion, said aloud. lib/ is compiled with -Werror=float-conversion.
template <class To, class From>
constexpr To cast(From value) {
    return static_cast<To>(value);
}

}  // namespace raylab
