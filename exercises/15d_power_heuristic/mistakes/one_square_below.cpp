// hint: one_square_below
#include "raylab/transport/power_heuristic.h"

double raylab::power_heuristic(double pdf, double other) { return pdf / (pdf * pdf + other * other); }
