#include "raylab/sampling/mapping/lens_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    // The share of the unit disk left of x is (acos(-x) + x sqrt(1 - x^2)) / pi, which has no inverse in closed form;
    // then any place of the column is as good as another.
    double left = -1, right = 1;
    while (right - left > 1e-15) {
        const double x = (left + right) / 2;
        if (x == left || x == right) break;
        const double share = (std::acos(-x) + x * std::sqrt(1 - x * x)) / std::numbers::pi;
        (share < u ? left : right) = x;
    }
    return {radius * left, radius * (2 * v - 1) * std::sqrt(std::max(0.0, 1 - left * left))};
}
