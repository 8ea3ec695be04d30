#pragma once

#include "raylab/scene/scene.h"

namespace raylab {

/// A direction in which a path goes on.
struct LobeSample {
    Vec3d direction;  // unit
    Color weight;     // value / pdf, which is what the path's throughput is multiplied by
    double pdf;       // per steradian
};

}  // namespace raylab
