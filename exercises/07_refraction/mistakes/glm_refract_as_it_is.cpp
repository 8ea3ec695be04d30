// hint: zero_vector
// Returns what GLM's function gives: it cannot say that there is no refracted ray, and gives the zero vector.
#include "raylab/tracer/refracted_direction.h"

std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    return glm::refract(direction, normal, ior_before / ior_behind);
}
