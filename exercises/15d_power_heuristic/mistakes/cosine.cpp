// hint: root
// The cosine of the angle, not its square.
#include "raylab/transport/power_heuristic.h"

#include <cmath>

double raylab::power_heuristic(double pdf, double other) { return std::cos(std::atan2(other, pdf)); }
