// hint: infinity_over_infinity
#include "raylab/transport/power_heuristic.h"

double raylab::power_heuristic(double pdf, double other) {
    const double larger = pdf > other ? pdf : other;
    const double a = pdf / larger, b = other / larger;
    return a * a / (a * a + b * b);
}
