// hint: at_one_distance
#include "raylab/geometry/local_frame.h"
#include "raylab/transport/light/light_point.h"

#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    Vec3d w = center - from;
    double d = glm::length(w);
    double cm = std::sqrt(1 - radius * radius / (d * d));
    LocalFrame fr = frame_around(w / d);
    double c = 1 - u * (1 - cm), s = std::sqrt(1 - c * c), a = 2 * std::numbers::pi * v;
    Vec3d dir = fr.to_world({s * std::cos(a), s * std::sin(a), c});
    return {from + (d - radius) * dir, 1 / (2 * std::numbers::pi * (1 - cm))};
}
