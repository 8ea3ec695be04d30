#include "raylab/tracer/phong_specular.h"

#include "raylab/tracer/shading/power.h"

#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const double incline = dot(normal, to_light);
    if (!(incline > 0)) return 0;
    // R = 2 (N.L) N - (N.N) L is N.N |L| long, whatever the lengths of N and L: one square root serves all three.
    const double square = dot(normal, normal);
    const double along_viewer = 2 * incline * dot(normal, to_viewer) - square * dot(to_light, to_viewer);
    if (!(along_viewer > 0)) return 0;
    return power(along_viewer / (square * std::sqrt(dot(to_light, to_light) * dot(to_viewer, to_viewer))), shininess);
}
