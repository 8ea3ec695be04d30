// hint: small_light
// Takes half of the squared sine for the height of the cap, which it is for small lights only.
#include "raylab/transport/light/light_point.h"

#include "raylab/geometry/local_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const double d = glm::length(center - from), sine_max = radius / d, cap = sine_max * sine_max / 2;
    const double cosine = 1 - cap * v, sine = std::sqrt(1 - cosine * cosine), turn = 2 * std::numbers::pi * u;
    const Vec3d ray =
        frame_around((center - from) / d).to_world({sine * std::sin(turn), sine * std::cos(turn), cosine});
    const double t = d * cosine - std::sqrt(std::max(0.0, radius * radius - d * d * sine * sine));
    return {from + t * ray, 0.5 / (std::numbers::pi * cap)};
}
