#pragma once

#include "raylab/geometry/vector.h"

namespace raylab {

/// A cell of the cube about a light: each face has resolution x resolution of them.
struct LightCell {
    int face;    // 0 to 5: +x, -x, +y, -y, +z, -z
    int column;  // along the axis after the face's own (x, y, z, x, ...), from -1 to 1
    int row;     // along the one after that

    friend bool operator==(const LightCell&, const LightCell&) = default;
};

/// The cell that a direction from the light goes through; its length does not matter, but it is not zero. Of faces or
/// cells that it goes between each will do; the lab's own function takes the face of the first axis, and the cell with
/// the larger numbers. This is the slot of exercise 08.
LightCell light_cell(const Vec3d& direction, int resolution);

}  // namespace raylab
