#include "raylab/sampling/mapping/lens_point.h"

#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    // Shirley and Chiu's map, wedge by wedge.
    const double a = 2 * u - 1, b = 2 * v - 1, quarter = std::numbers::pi / 4;
    double r, turns;  // in eighths
    if (a > -b) {
        if (a > b) {
            r = a;
            turns = b / a;
        } else {
            r = b;
            turns = 2 - a / b;
        }
    } else {
        if (a < b) {
            r = -a;
            turns = 4 + b / a;
        } else {
            r = -b;
            turns = b != 0 ? 6 - a / b : 0;
        }
    }
    return {radius * r * std::cos(quarter * turns), radius * r * std::sin(quarter * turns)};
}
