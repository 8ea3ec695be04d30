#pragma once

#include "seen_points.h"

#include "raylab/geometry/local_frame.h"

#include <cmath>

// Cones of which an axis is not of length 1.

namespace raylab::grading::light {

/// Whether the points are even in a cone of which the three axes are those that frame_around makes of the whole way to
/// the light, not of a unit vector.
inline bool are_even_in_a_squashed_cone(const Points& points) {
    const LocalFrame frame = frame_around(points.given.center - points.given.from);
    const glm::dmat3 to_local = glm::inverse(glm::dmat3(frame.x, frame.y, frame.z));
    std::vector<DrawnShare> shares;
    for (std::size_t i = 0; i < pairs; ++i) {
        const Vec3d local = glm::normalize(to_local * (points.at(i).point - points.given.from));
        shares.push_back({(1 - local.z) / (1 - points.cosine_max()), turn_share(local.x, local.y)});
    }
    return have_even_insides(shares) && have_even_turns(shares);
}

/// Whether the points are even in a cone whose axes across are a cross product of the way and x, y or z, and what is
/// made of that, as short as they are.
inline bool are_even_by_short_axes(const Points& points) {
    const Vec3d way = points.axis();
    for (const int helper : {0, 1, 2})
        for (const bool is_second_unit : {false, true}) {
            Vec3d across{0, 0, 0};
            across[helper] = 1;
            across = cross(across, way);
            const double squared = dot(across, across);
            const Vec3d second = is_second_unit ? glm::normalize(cross(way, across)) : cross(way, across);
            std::vector<DrawnShare> shares;
            for (std::size_t i = 0; squared > 1e-9 && squared < 1 - 1e-9 && i < pairs; ++i) {
                const Vec3d ray = glm::normalize(points.at(i).point - points.given.from);
                const double x = dot(ray, across) / squared, y = dot(ray, second) / dot(second, second);
                const double z = dot(ray, way);
                shares.push_back({(1 - z / std::hypot(x, y, z)) / (1 - points.cosine_max()), turn_share(x, y)});
            }
            if (have_even_insides(shares) && have_even_turns(shares)) return true;
        }
    return false;
}

}  // namespace raylab::grading::light
