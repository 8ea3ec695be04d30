// hint: squares_leave_the_doubles
// The formula as it stands.
#include "raylab/transport/power_heuristic.h"

double raylab::power_heuristic(double pdf, double other) {
    const double a = pdf * pdf, b = other * other;
    return a / (a + b);
}
