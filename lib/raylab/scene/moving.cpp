#include "raylab/scene/moving.h"

#include "raylab/geometry/placement_at.h"

#include <algorithm>
#include <cmath>

namespace raylab {

Interval<float> ray_times(const std::optional<Shutter>& shutter) {
    if (!shutter) return {0, 0};
    const auto [open, close] = *shutter;
    return {std::min(0.0f, cast<float>(open)), std::max(0.0f, cast<float>(close))};
}

// Seen from an object that only translates, it is the region that moves, the other way.
Containment containment_always(const Scene& scene, const Object& object, const Region& region) {
    const Motion* motion = motion_of(scene, object);
    if (!motion) return containment(region, object.shape, object.placement);
    if (!only_translates(*motion)) return Containment::undecided;
    const auto [begin, end] = ray_times(scene);
    const double longest = std::max(-double{begin}, double{end}) * (1 + 0x1p-40);  // for the rounding of the sums
    const auto widened = [&](const Enclosure& x, float speed) {
        return Enclosure(x.middle(), x.radius() + std::abs(speed * longest));
    };
    const Vec3f& v = motion->translation;
    return containment({widened(region.x, v.x), widened(region.y, v.y), widened(region.z, v.z)}, object.shape,
                       object.placement);
}

bool anything_moves(const Scene& scene) {
    return std::ranges::any_of(scene.objects,
                               [&](const Object& object) { return motion_of(scene, object) != nullptr; });
}

}  // namespace raylab
