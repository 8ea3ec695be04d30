#pragma once

#include <array>
#include <cmath>
#include <numbers>

namespace raylab {

/// A point of the plane: of the disk of radius 1 around the origin.
struct DiskPoint {
    double x, y;
};

/// Maps the unit square to the disk of radius 1 so that equal areas stay equal, squares around the centre become
/// circles, and neighbours stay neighbours (Shirley and Chiu, "A Low Distortion Map Between Disk and Square", Journal
/// of Graphics Tools 2(3), 1997). Its density is 1 / pi.
inline DiskPoint concentric_disk(double u, double v) {
    const double x = 2 * u - 1, y = 2 * v - 1;
    if (x == 0 && y == 0) return {0, 0};
    const bool beside = std::abs(x) > std::abs(y);  // in the quarters left and right of the centre
    const double radius = beside ? x : y;
    const double turn = std::numbers::pi / 4 * (beside ? y / x : x / y);
    const double near = radius * std::cos(turn), far = radius * std::sin(turn);
    return beside ? DiskPoint{near, far} : DiskPoint{far, near};
}

}  // namespace raylab
