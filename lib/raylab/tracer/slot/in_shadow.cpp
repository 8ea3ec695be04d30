#include "raylab/tracer/in_shadow.h"

#include "raylab/geometry/largest_coordinate.h"

#include <algorithm>

namespace {

// A point computed in doubles is off its surface by its last bits: some dozens of 2^-53 of the numbers that made it,
// and more where a far camera or a small sphere made digits cancel. 2^-33 leaves room for a loss of six digits, and is
// a tenth of a micrometre in a scene of a kilometre: nothing that casts a shadow is thinner.
constexpr double share_of_size = 0x1p-33;

}  // namespace

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    if (!(dot(normal, light - point) > 0)) return true;  // behind the surface
    const Vec3d start =
        point + normal * (share_of_size * std::max(largest_coordinate(point), largest_coordinate(light)));
    // The light is at t = 1 of a direction that is not made unit. It is taken from the start, not from the point: a
    // light that stands low over the surface stays above it all the way.
    const auto t = first_hit(start, light - start);
    return t && *t < 1 - share_of_size;
}
