// hint: sums_to_two
// A mean of two without the half.
#include "raylab/transport/power_heuristic.h"

#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    const double sine = std::sin(std::atan2(pdf, other));
    return sine * sine + sine * sine;
}
