// hint: power_of_three
// Squares twice.
#include "raylab/transport/power_heuristic.h"

#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    if (std::isinf(pdf)) return 1;
    double ratio = other / pdf;
    for (int i = 0; i < 2; ++i) ratio *= ratio;
    return 1 / (ratio + 1);
}
