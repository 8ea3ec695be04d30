#include "raylab/transport/light/light_point.h"
#include "raylab/base/unfinished.h"

// Exercise 15c. README.md beside this file says what to write; ./raylab check 15c says how it went.
raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    throw Unfinished{};
}
