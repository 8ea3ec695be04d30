#pragma once

#include "arguments.h"

#include <algorithm>
#include <cmath>

// The truth, by geometry and without any ray: the distance of the segment to the light from each center, in long
// double.

namespace raylab::grading::shadow {

inline constexpr double margin = 0.02;  // of a radius, between the segment of a graded case and a sphere's rim
using Exact = glm::vec<3, long double, glm::defaultp>;

/// The distance of the segment from point to light from a sphere.
inline long double clearance(const Arguments& given, const SphereOf<double>& sphere) {
    const Exact from = convert<long double>(given.point), way = convert<long double>(given.light) - from;
    const Exact center = convert<long double>(sphere.center);
    const long double along = std::clamp(dot(center - from, way) / dot(way, way), 0.0L, 1.0L);
    return glm::length(center - (from + along * way)) - static_cast<long double>(sphere.radius);
}

inline bool is_behind(const Arguments& given) { return dot(given.normal, given.light - given.point) <= 0; }

inline bool is_dark(const Arguments& given) {
    return is_behind(given) || std::ranges::any_of(given.spheres, [&](const auto& sphere) {
               return sphere.radius > 0 && clearance(given, sphere) < 0;
           });
}

/// Whether every sphere's rim is far enough from the segment for any correct method.
inline bool keeps_margin(const Arguments& given) {
    return std::ranges::all_of(given.spheres, [&](const auto& sphere) {
        return sphere.radius == 0 || std::abs(clearance(given, sphere)) > margin * sphere.radius;
    });
}

}  // namespace raylab::grading::shadow
