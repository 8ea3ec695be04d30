// hint: the_larger_wins
#include "raylab/transport/power_heuristic.h"

double raylab::power_heuristic(double pdf, double other) {
    if (pdf == other) return 0.5;
    return pdf > other;
}
