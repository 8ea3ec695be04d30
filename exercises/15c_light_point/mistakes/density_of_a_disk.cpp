// hint: pdf_of_a_flat_light
#include "raylab/geometry/local_frame.h"
#include "raylab/transport/light/light_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    Vec3d w = center - from;
    double d = glm::length(w);
    double cm = std::sqrt(1 - radius * radius / (d * d));
    LocalFrame fr = frame_around(w / d);
    double c = 1 - u * (1 - cm), s = std::sqrt(1 - c * c), a = 2 * std::numbers::pi * v;
    Vec3d dir = fr.to_world({s * std::cos(a), s * std::sin(a), c});
    double t = d * c - std::sqrt(std::max(0.0, radius * radius - d * d * s * s));
    return {from + t * dir, d * d / (std::numbers::pi * radius * radius)};
}
