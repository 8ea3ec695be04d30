#include "squares.h"

#include <cmath>
#include <numbers>

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

KnownPair facing_5_apart() { return {lower_square(), upper_square(5), 0.0124039773132451}; }
KnownPair facing_1_apart() { return {lower_square(), upper_square(1), 0.199824895698387}; }
KnownPair facing_half_apart() { return {lower_square(), upper_square(0.5), 0.415253283577147}; }
KnownPair facing_tenth_apart() { return {lower_square(), upper_square(0.1), 0.826994522397257}; }
KnownPair sharing_an_edge() { return {lower_square(), leaning_square(std::numbers::pi / 2), 0.200043776075403}; }

}  // namespace raylab::cornell
