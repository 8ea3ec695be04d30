// hint: facing_hemisphere
// or: even_on_the_disk
// The light is a disk, as if it were far away: an even point of it, lifted to the sphere.
#include "raylab/geometry/local_frame.h"
#include "raylab/transport/light/light_point.h"

#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const double squared = dot(from - center, from - center);
    const LocalFrame frame = frame_around((from - center) / std::sqrt(squared));
    const double r = radius * std::sqrt(u), angle = 2 * std::numbers::pi * v;
    const Vec3d place{r * std::cos(angle), r * std::sin(angle), radius * std::sqrt(1 - u)};
    return {center + frame.to_world(place), squared / (std::numbers::pi * radius * radius)};
}
