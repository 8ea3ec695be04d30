#pragma once

#include "raylab/geometry/ray.h"
#include "raylab/geometry/shapes.h"

// Most rays that come near a cylinder or cone miss it, and most of these leave it or go round it: plain doubles see that
// sooner than the filter of the whole question, in meet_revolution.h.

namespace raylab::detail {

/// What both ask of an axis, with p = origin - base, g = top - base, and the squares of lengths that bound what rounding does.
///
/// p and g carry one rounding a coordinate, which is relative; a sum of products of n factors then errs by less than 2^-46 of
/// the product of their lengths, a cross product counted twice (Cauchy): tests/geometry/roundings.cpp counts far fewer.
struct AxisInDoubles {
    double length, from_base, of_direction;  // g.g, p.p, d.d
    double place, speed;                     // p.g, d.g
    double place_doubt;
    Vec3d moment, rate;                      // p x g, d x g

    AxisInDoubles(const Ray& ray, const Vec3f& base, const Vec3f& top) {
        const Vec3d g = convert<double>(top) - convert<double>(base), d = convert<double>(ray.direction);
        const Vec3d p = convert<double>(ray.origin) - convert<double>(base);
        length = dot(g, g), from_base = dot(p, p), of_direction = dot(d, d);
        place = dot(p, g), speed = dot(d, g);
        place_doubt = 0x1p-46 * (from_base + length);
        moment = cross(p, g), rate = cross(d, g);
    }

    /// Whether products of these stay in range: what is too large makes bounds infinite, and decides nothing.
    bool is_tame() const { return length > 0x1p-40 && of_direction > 0x1p-80; }

    /// Surely beyond base or top, and going on that way.
    bool leaves_slab() const {
        if (!(speed * speed > 0x1p-90 * of_direction * length)) return false;
        return speed > 0 ? place - length > place_doubt : place < -place_doubt;
    }
};

/// F(t) = a t^2 + 2 b t + c, with bounds of the errors of a and c and of the square of b's.
struct QuadraticInDoubles {
    double a, b, c, a_doubt, c_doubt, squared_b_size;

    /// F is surely positive for all t >= 0.
    bool stays_positive() const {
        if (!(c > c_doubt && a > a_doubt)) return false;
        if (b > 0 && b * b > 0x1p-90 * squared_b_size) return true;
        const double ac = a * c;
        return b * b - ac < -(0x1p-45 * squared_b_size + a_doubt * c + (a + a_doubt) * c_doubt + 0x1p-50 * ac);
    }
};

inline QuadraticInDoubles outside(const AxisInDoubles& axis, const Cylinder& cylinder) {
    const double q = axis.of_direction, p = axis.from_base, l = axis.length;
    const double limit = double{cylinder.radius} * cylinder.radius * l;
    return {.a = dot(axis.rate, axis.rate),
            .b = dot(axis.moment, axis.rate),
            .c = dot(axis.moment, axis.moment) - limit,
            .a_doubt = 0x1p-46 * (2 * q * l),
            .c_doubt = 0x1p-46 * (2 * p * l + limit),
            .squared_b_size = 4 * l * l * p * q};
}

inline QuadraticInDoubles outside(const AxisInDoubles& axis, const Cone& cone) {
    const double q = axis.of_direction, p = axis.from_base, l = axis.length;
    const double base = cone.base_radius, growth = double{cone.top_radius} - base;
    const double radius = base * l + growth * axis.place, widening = growth * axis.speed;
    const double squared_growth = growth * growth, width = base * base * l + squared_growth * p;  // radius^2 is below 2 l width
    return {.a = l * dot(axis.rate, axis.rate) - widening * widening,
            .b = l * dot(axis.moment, axis.rate) - radius * widening,
            .c = l * dot(axis.moment, axis.moment) - radius * radius,
            .a_doubt = 0x1p-46 * q * l * (2 * l + squared_growth),
            .c_doubt = 0x1p-46 * 2 * l * (p * l + width),
            .squared_b_size = 4 * l * l * q * (2 * l * l * p + width * squared_growth)};
}

}  // namespace raylab::detail

namespace raylab {

/// Whether a ray surely misses a cylinder or cone, caps or none: it goes away from the slab between base and top, or stays
/// outside of the surface without ends. False says nothing.
template <class S>
bool surely_passes(const Ray& ray, const S& shape) {
    const detail::AxisInDoubles axis(ray, shape.base, shape.top);
    if (!(ray.range.min >= 0) || !axis.is_tame()) return false;
    return axis.leaves_slab() || outside(axis, shape).stays_positive();
}

}  // namespace raylab
