// hint: squares_leave_the_doubles
#include "raylab/transport/power_heuristic.h"

double raylab::power_heuristic(double pdf, double other) {
    if (pdf > 1e308) return 1;
    if (other > 1e308) return 0;
    return pdf * pdf / (pdf * pdf + other * other);
}
