#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    // The angle under which an edge is seen, times the cosine between the normal and the plane of edge and point.
    // acos would lose half of the digits of a small angle.
    const auto edge_term = [&normal](const Vec3d& from, const Vec3d& to) {
        const Vec3d across = cross(to - from, from);  // cross(to, from) would cancel where the two are close
        const double sine = glm::length(across);      // times both lengths, as the cosine dot(from, to) is
        return sine > 0 ? std::atan2(sine, dot(from, to)) * dot(normal, across) / sine : 0;
    };

    double sum = 0;
    Vec3d area_vector{0, 0, 0};           // twice the polygon's area, along its normal
    Vec3d entry{0, 0, 0}, exit{0, 0, 0};  // where the contour comes up over the horizon, and where it goes down
    Vec3d from = polygon.back() - point;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d to = polygon[i] - point;
        const double height_from = dot(normal, from), height_to = dot(normal, to);
        if (i > 0) area_vector += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
        if (height_from > 0 || height_to > 0) {
            const auto crossing = [&] { return from + (to - from) * (height_from / (height_from - height_to)); };
            if (height_from <= 0) entry = crossing();
            if (height_to <= 0) exit = crossing();
            sum += edge_term(height_from <= 0 ? entry : from, height_to <= 0 ? exit : to);
        }
        from = to;
    }
    sum += edge_term(exit, entry);  // along the horizon; both are zero where nothing is clipped

    // Closer than this a point is in the polygon's plane: it is the rounding error of the coordinates.
    const double closest = 1e-14 * (glm::length(point) + glm::length(polygon[0]));
    const bool is_in_front = dot(area_vector, point - polygon[0]) > closest * glm::length(area_vector);
    return is_in_front ? std::max(0.0, sum / (2 * std::numbers::pi)) : 0;
}
