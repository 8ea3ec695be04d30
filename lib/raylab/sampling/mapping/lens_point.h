#pragma once

#include "raylab/sampling/mapping/concentric_disk.h"

namespace raylab {

/// The point of a round lens that two uniform numbers in [0, 1) stand for, in metres from the lens' centre: uniform in
/// area. This is the slot of exercise 15.
DiskPoint lens_point(double radius, double u, double v);

}  // namespace raylab
