#include "raylab/transport/power_heuristic.h"

// By the ratio of the two, since squares of densities leave the doubles: a tiny light has a density of 10^200.
double raylab::power_heuristic(double pdf, double other) {
    if (pdf >= other) return 1 / (1 + (other / pdf) * (other / pdf));
    const double ratio = pdf / other;
    return ratio * ratio / (1 + ratio * ratio);
}
