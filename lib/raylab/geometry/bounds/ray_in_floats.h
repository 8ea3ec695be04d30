#pragma once

#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/ray.h"
#include "raylab/number/four_floats.h"

#include <cstddef>
#include <cstring>

namespace raylab {

/// A ray and the bounds of everything inside a box, in floats.
struct RayInFloats {
    FourFloats origin, direction;  // the fourth floats mean nothing here
    FourFloats steep,
        reach;  // the direction's sizes; no point of the box is farther from the origin, but for a rounding

    RayInFloats(const Ray& ray, const Box& all) {
        std::memcpy(&origin, reinterpret_cast<const std::byte*>(&ray) + offsetof(Ray, origin), sizeof origin);
        std::memcpy(&direction, reinterpret_cast<const std::byte*>(&ray) + offsetof(Ray, direction), sizeof direction);
        const FourFloats low{all.min.x, all.min.y, all.min.z, 0}, high{all.max.x, all.max.y, all.max.z, 0};
        steep = magnitude(direction);
        reach = larger(magnitude(low - origin), magnitude(high - origin));
    }

    /// True if they are far from under- and overflowing: then distances are at most 2^40, directions between 2^-60 and
    /// 2^40 or zero, and not all of them zero.
    bool fit_floats() const {
        const FourInts straight = steep >= all_four(0x1p-60f), none = steep == all_four(0);
        const FourInts fitting = (reach <= all_four(0x1p40f)) & (steep <= all_four(0x1p40f)) & (straight | none);
        return three_signs(fitting) == 7 && three_signs(none) != 7;
    }
};

}  // namespace raylab
