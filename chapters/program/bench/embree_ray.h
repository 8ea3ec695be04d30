#pragma once

#include "raylab/geometry/ray.h"

#include <embree3/rtcore.h>

namespace raylab::bench {

/// The ray as Embree 3 takes it, with its range, at time 0 and seen by all masks.
inline RTCRay in_embree(const Ray& ray) {
    return {ray.origin.x,
            ray.origin.y,
            ray.origin.z,
            ray.range.min,
            ray.direction.x,
            ray.direction.y,
            ray.direction.z,
            0,
            ray.range.max,
            ~0u,
            0,
            0};
}

}  // namespace raylab::bench
