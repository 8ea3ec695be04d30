// hint: ratio_alone
#include "raylab/transport/power_heuristic.h"

double raylab::power_heuristic(double pdf, double other) { return other > 0 ? pdf / other : 1; }
