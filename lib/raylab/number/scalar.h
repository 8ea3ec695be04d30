#pragma once

#include "raylab/number/ieee_754.h"

#include <concepts>
#include <limits>

namespace raylab {

/// The operations that predicates need, which never divide: float, double, long double, Enclosure, Rational.
template <class T>
concept Scalar = requires(T a, T b) {
    T(1.0);
    { a + b } -> std::convertible_to<T>;
    { a - b } -> std::convertible_to<T>;
    { a* b } -> std::convertible_to<T>;
    { -a } -> std::convertible_to<T>;
};

/// An ordered machine number with division and square root, in which the methods of the literature compute.
template <class T>
concept Real = Scalar<T> && std::floating_point<T>;

/// The relative error of one rounded operation in T: 2^-24 for float, 2^-53 for double.
template <Real T>
inline constexpr T unit_roundoff = std::numeric_limits<T>::epsilon() / 2;

/// A machine number's name in tables and charts.
template <Real T>
inline constexpr const char* number_name = "long double";
template <>
inline constexpr const char* number_name<double> = "double";
template <>
inline constexpr const char* number_name<float> = "float";

/// A narrowing conversion, written explicitly. lib/ is compiled with -Werror=float-conversion.
template <class To, class From>
constexpr To cast(From value) {
    return static_cast<To>(value);
}

}  // namespace raylab
