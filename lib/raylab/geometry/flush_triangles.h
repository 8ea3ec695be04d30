#pragma once

#include "raylab/geometry/shapes.h"

namespace raylab {

/// Whether two triangles lie in the same plane across an axis, as a floor and what is flush with it: a ray that hits
/// both, hits them at the same t.
inline bool are_flush(const Triangle& one, const Triangle& other) {
    for (int axis = 0; axis < 3; ++axis) {
        const float at = one.a[axis];
        if (one.b[axis] == at && one.c[axis] == at && other.a[axis] == at && other.b[axis] == at && other.c[axis] == at)
            return true;
    }
    return false;
}

}  // namespace raylab
