#include "raylab/radiosity/form_factor/uniform_points.h"

#include "raylab/radiosity/form_factor/convex_polygon.h"

#include <algorithm>
#include <cmath>

namespace raylab {

UniformPoints::UniformPoints(std::span<const Vec3d> polygon) {
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const Vec3d first = polygon[i - 1] - polygon[0], second = polygon[i] - polygon[0];
        fan_.push_back({polygon[0], first, second, 0.5 * glm::length(cross(first, second))});
        area_ += fan_.back().area;
    }
    parallelogram_ = polygon.size() == 4 &&
                     glm::length(polygon[0] - polygon[1] + polygon[2] - polygon[3]) <= rounding_height(polygon);
}

Vec3d UniformPoints::at(double u, double v) const {
    if (parallelogram_) return fan_[0].corner + u * fan_[0].first_side + v * fan_[1].second_side;
    double rest = u * area_;
    std::size_t i = 0;
    while (i + 1 < fan_.size() && rest > fan_[i].area) rest -= fan_[i++].area;
    const Triangle& triangle = fan_[i];
    const double away = std::sqrt(std::min(1.0, rest / triangle.area));  // the share of the way to the opposite side
    return triangle.corner + away * ((1 - v) * triangle.first_side + v * triangle.second_side);
}

}  // namespace raylab
