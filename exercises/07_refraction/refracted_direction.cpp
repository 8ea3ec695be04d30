#include "raylab/tracer/refracted_direction.h"
#include "raylab/base/unfinished.h"

// Exercise 07. README.md beside this file says what to write; ./raylab check 07 says how it went.
std::optional<raylab::Vec3d> raylab::refracted_direction(const Vec3d& direction, const Vec3d& normal, double ior_before,
                                                         double ior_behind) {
    throw Unfinished{};
}
