// hint: power_of_three
// Both densities are the sides of a right angle, and a cube is taken of each.
#include "raylab/transport/power_heuristic.h"

#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    const double angle = std::atan2(other, pdf);
    const auto cube = [](double side) { return side * side * side; };
    const double mine = cube(std::cos(angle)), theirs = cube(std::sin(angle));
    return mine / (mine + theirs);
}
