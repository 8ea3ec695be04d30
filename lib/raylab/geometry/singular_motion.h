#pragma once

#include "raylab/geometry/affine.h"
#include "raylab/geometry/ray.h"

namespace raylab {

/// True if the exact determinant of M + t R is zero at any t of the closed range, which is finite: such a motion is
/// refused.
bool is_singular_during(const Affine& placement, const Motion& motion, const Interval<float>& times);

}  // namespace raylab
