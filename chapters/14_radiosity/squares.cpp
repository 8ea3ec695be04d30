#include "squares.h"

#include <cmath>

namespace raylab::cornell {

Quadrilateral lower_square() { return {Vec3d{0, 0, 0}, Vec3d{1, 0, 0}, Vec3d{1, 1, 0}, Vec3d{0, 1, 0}}; }

Quadrilateral upper_square(double height, double side) {
    const double low = (1 - side) / 2, high = (1 + side) / 2;
    return {Vec3d{low, low, height}, Vec3d{low, high, height}, Vec3d{high, high, height}, Vec3d{high, low, height}};
}

Quadrilateral leaning_square(double angle) {
    const double y = std::cos(angle), z = std::sin(angle);
    return {Vec3d{0, 0, 0}, Vec3d{0, y, z}, Vec3d{1, y, z}, Vec3d{1, 0, 0}};
}

}  // namespace raylab::cornell
