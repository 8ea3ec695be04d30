#pragma once

#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/shapes.h"

namespace raylab {

/// A box for tests in doubles: its middle, and half its sides.
struct BoxOfDoubles {
    Vec3d center, half;
};

/// True if the triangle reaches into the box, by separating axes (Akenine-Moeller, Fast 3D Triangle-Box Overlap
/// Testing, JGT 6(1), 2001). Never false where it does, if the box has been grown on all sides by 2^-46 of the largest
/// coordinate about: a projection is rounded fewer than ten times.
bool reaches(const Triangle& triangle, const BoxOfDoubles& box);

/// True if the sphere's surface reaches into the box: a box surely inside the ball is not reached. The same promise.
bool reaches(const Sphere& sphere, const BoxOfDoubles& box);

}  // namespace raylab
