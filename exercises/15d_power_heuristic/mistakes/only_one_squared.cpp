// hint: only_one_squared
#include "raylab/transport/power_heuristic.h"

double raylab::power_heuristic(double pdf, double other) { return pdf * pdf / (pdf + other); }
