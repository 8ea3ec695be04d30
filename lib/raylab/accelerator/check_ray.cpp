#include "raylab/accelerator/check_ray.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace raylab {

namespace {

bool is_finite(const Vec3f& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

std::string text(const Vec3f& v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); }

}  // namespace

void check_ray(const Ray& ray, const std::function<Place()>& place) {
    const auto& [min, max] = ray.range;
    if (!is_finite(ray.origin)) throw Error(place(), "a finite origin", text(ray.origin));
    if (!is_finite(ray.direction)) throw Error(place(), "a finite direction", text(ray.direction));
    if (ray.direction == Vec3f(0, 0, 0)) throw Error(place(), "a direction that is not zero", text(ray.direction));
    constexpr float infinity = std::numeric_limits<float>::infinity();
    if (!std::isfinite(min) && min != -infinity)
        throw Error(place(), "a tmin that is finite or -infinity", fmt::format("{}", min));
    if (!std::isfinite(max) && max != infinity)
        throw Error(place(), "a tmax that is finite or +infinity", fmt::format("{}", max));
}

}  // namespace raylab
