// hint: eta_inverted
// By the part along the surface, which is always made shorter: as if every ray went into the denser medium.
#include "raylab/tracer/refracted_direction.h"

#include <cmath>

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    const bool leaves_the_denser = ior_before > ior_behind;
    const double eta = leaves_the_denser ? ior_behind / ior_before : ior_before / ior_behind;
    const Vec3d along = eta * (direction - dot(direction, normal) * normal);
    return along - std::sqrt(1 - dot(along, along)) * normal;
}
