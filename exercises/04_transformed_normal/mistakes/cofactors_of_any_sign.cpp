// hint: mirror_forgotten
// Cofactors, whose sign a mirror turns.
#include "raylab/geometry/transformed_normal.h"

#include <cmath>

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const Vec3d& a = columns[0];
    const Vec3d& b = columns[1];
    const Vec3d& c = columns[2];
    Vec3d r = normal.x * cross(b, c);
    r += normal.y * cross(c, a);
    r += normal.z * cross(a, b);
    const double len = std::sqrt(r.x * r.x + r.y * r.y + r.z * r.z);
    return r * (1.0 / len);
}
