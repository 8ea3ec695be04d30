#pragma once

#include "raylab/number/dyadic.h"
#include "raylab/number/enclosure.h"
#include "raylab/number/estimate.h"
#include "raylab/number/fine_enclosure.h"
#include "raylab/number/sign.h"

namespace raylab {

/// The number t = (-b + branch * sqrt(discriminant)) / a, which is not computed where its sign suffices. For branch
/// zero it is the quotient -b/a, and c and discriminant are zero. Otherwise it is a root of a t^2 + 2 b t + c = 0,
/// whose discriminant b^2 - a c is not negative.
template <Scalar T>
struct Root {
    T a, b, c, discriminant;
    Sign branch;
};

/// The number numerator / denominator, where the denominator is not zero.
template <Scalar T>
Root<T> ratio(const T& numerator, const T& denominator) {
    return {denominator, -numerator, T(0.0), T(0.0), Sign::zero};
}

/// The sign of p + q t at t = root, computed without a square root; it is exact where T is.
template <Scalar T>
Sign sign_at(const Root<T>& root, const T& p, const T& q, Signs<T>& signs) {
    const Sign of_a = signs.of(root.a);
    const T rational = root.a * p - root.b * q;  // a (p + q t) = rational + q branch sqrt(discriminant)
    if (root.branch == Sign::zero) return of_a * signs.of(rational);

    const Sign of_surd = signs.of(q) * root.branch;
    // rational^2 - q^2 discriminant = a (a p^2 - 2 b p q + c q^2), whose sign tells which of the two terms is larger
    const Sign heavier = of_a * signs.of(p * (root.a * p - (root.b + root.b) * q) + root.c * (q * q));
    if (heavier == Sign::negative) return of_a * of_surd;
    const Sign of_rational = signs.of(rational);
    if (heavier == Sign::positive) return of_a * of_rational;
    return of_rational == of_surd ? of_a * of_rational : Sign::zero;  // of equal size: they add up or cancel
}

/// The sign of t - x.
template <Scalar T>
Sign compare(const Root<T>& root, const T& x, Signs<T>& signs) {
    return sign_at(root, -x, T(1.0), signs);
}

/// The sign of t - s, exactly, for roots of different equations.
Sign compare(const Root<Dyadic>& t, const Root<Dyadic>& s);

/// An enclosure of the root.
Enclosure value(const Root<Estimate>& root);
Enclosure value(const Root<Enclosure>& root);
Enclosure value(const Root<FineEnclosure>& root);  // mostly within a few units in the last place of a double
Enclosure value(const Root<Dyadic>& root);         // within 2 units

}  // namespace raylab
