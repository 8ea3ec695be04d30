#pragma once

#include "raylab/geometry/vector.h"

namespace raylab {

/// A direction chosen at random.
struct SampledDirection {
    Vec3d direction;  // unit
    double pdf;       // how likely directions near it are, per steradian
};

}  // namespace raylab
