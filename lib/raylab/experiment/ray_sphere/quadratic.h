#pragma once

#include "raylab/geometry/ray.h"

#include <cmath>
#include <optional>
#include <utility>

// The roots of a quadratic: the arithmetic under every curved surface of the lab (chapter 02, equations 2 to 5).

namespace raylab {

/// a t^2 + 2 b t + c, with half the middle coefficient: that is what dot products give, and the school formula's 2 and
/// 4 cancel without changing a bit, being powers of two.
template <Real T>
struct Quadratic {
    T a, half_b, c;

    T discriminant() const { return half_b * half_b - a * c; }
};

/// Both zeros, the smaller first; one of them is infinite where the quadratic is linear.
template <Real T>
struct Roots {
    T low, high;
};

template <Real T>
Roots<T> in_order(T one, T other) {
    return one <= other ? Roots<T>{one, other} : Roots<T>{other, one};
}

/// The school formula (-b +- sqrt(D)) / a. It loses the digits of the root in which b and sqrt(D) cancel.
template <Real T>
std::optional<Roots<T>> textbook_roots(const Quadratic<T>& quadratic, T discriminant) {
    if (!(discriminant >= 0)) return std::nullopt;
    const T root = std::sqrt(discriminant);
    return in_order((-quadratic.half_b - root) / quadratic.a, (-quadratic.half_b + root) / quadratic.a);
}

/// Adds where the school formula would subtract, and gets the other root from the product t0 t1 = c / a (Press,
/// Teukolsky, Vetterling and Flannery, Numerical Recipes, section 5.6). Also right where a is zero.
template <Real T>
std::optional<Roots<T>> stable_roots(const Quadratic<T>& quadratic, T discriminant) {
    if (!(discriminant >= 0)) return std::nullopt;
    const T q = -(quadratic.half_b + std::copysign(std::sqrt(discriminant), quadratic.half_b));
    if (q != 0) return in_order(quadratic.c / q, q / quadratic.a);
    // b and D are zero, so a or c is: a double root at zero, or no t^2 at all (and then no root, or every t is one).
    if (quadratic.a != 0) return Roots<T>{0, 0};
    return std::nullopt;
}

/// The smaller root inside the closed range: behind the start is no hit, and from inside it is the way out.
template <Real T>
std::optional<T> first_inside(const Interval<T>& range, const std::optional<Roots<T>>& roots) {
    if (!roots) return std::nullopt;
    if (contains(range, roots->low)) return roots->low;
    if (contains(range, roots->high)) return roots->high;
    return std::nullopt;
}

}  // namespace raylab
