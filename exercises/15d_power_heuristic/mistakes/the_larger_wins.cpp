// hint: the_larger_wins
#include "raylab/transport/power_heuristic.h"

double raylab::power_heuristic(double pdf, double other) { return pdf >= other ? 1 : 0; }
