#pragma once

#include "raylab/geometry/meet_revolution.h"
#include "raylab/geometry/verdict.h"

// Most rays that hit a cylinder or cone enter it from outside, clearly: that is told by where they cross its surface, at a
// third of the cost of the whole question in meet_revolution.h, and the t is the same.

namespace raylab {

namespace detail {

inline bool surely_before(const Enclosure& a, const Enclosure& b) { return a.upper() < b.lower(); }

inline Candidate on_part(const Enclosure& t, Part part) { return {t.middle(), t.radius(), static_cast<double>(part)}; }

// The ray crosses the surface without ends, from outside at `first`, but not between the planes of the caps: towards which
// it goes or not. F < 0 between the crossings and nowhere else, and a cap is where its plane has F <= 0.
template <class S>
FilterVerdict entry_by_cap(const Ray& ray, const S& shape, const AxisView<Estimate>& axis, const AlongRay<Estimate>& f,
                           const Enclosure& first, Part cap) {
    const auto upward = sign(axis.speed);
    if (shape.ends == Ends::open || !upward) return Undecided{};
    if (*upward == (cap == Part::base_cap ? Sign::negative : Sign::positive)) return Miss{};
    const Estimate way = cap == Part::top_cap ? axis.squared_length - axis.place : -axis.place;
    const Enclosure at_cap = value(ratio(way, axis.speed));
    const Enclosure last = value(Root<Estimate>{f.a, f.b, f.c, f.discriminant, Sign::positive});
    if (surely_before(last, at_cap)) return Miss{};
    const bool between = surely_before(first, at_cap) && surely_before(at_cap, last);
    return between && at_cap.upper() < ray.range.max ? FilterVerdict(on_part(at_cap, cap)) : Undecided{};
}

}  // namespace detail

/// The hit of a cylinder or cone seen from both sides, or that there is none, where a ray that is less steep than the surface
/// surely comes from outside.
template <class S>
FilterVerdict entry(const Ray& ray, const S& shape) {
    const LocalRay<Estimate> local = local_ray<Estimate>(ray, {});
    const AxisView<Estimate> axis = view(local, shape.base, shape.top);
    const AlongRay<Estimate> f = along(local, shape, axis);
    if (sign(f.a) != Sign::positive) return Undecided{};
    if (sign(f.discriminant) == Sign::negative) return Miss{};  // and caps lie where F <= 0
    if (sign(f.discriminant) != Sign::positive) return Undecided{};
    const Enclosure first = value(Root<Estimate>{f.a, f.b, f.c, f.discriminant, Sign::negative});
    if (first.lower() > ray.range.max) return Miss{};
    if (!(first.lower() > ray.range.min && first.upper() < ray.range.max)) return Undecided{};

    const Enclosure place = axis.place.enclosed() + axis.speed.enclosed() * first, top = axis.squared_length.enclosed();
    const Enclosure base(0);
    if (detail::surely_before(base, place) && detail::surely_before(place, top)) return detail::on_part(first, Part::side);
    if (detail::surely_before(place, base)) return detail::entry_by_cap(ray, shape, axis, f, first, Part::base_cap);
    if (detail::surely_before(top, place)) return detail::entry_by_cap(ray, shape, axis, f, first, Part::top_cap);
    return Undecided{};
}

}  // namespace raylab
