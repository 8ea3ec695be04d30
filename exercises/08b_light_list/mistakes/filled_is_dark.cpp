// hint: before_what_fills
// A filled cell is dark.
#include "raylab/accelerator/light_buffer/light_through_list.h"

#include <cmath>

double raylab::light_through_list(const AskedLightList& list) {
    if (std::isfinite(list.filled)) return 0;
    double left = 1;
    for (int i = 0; i < list.entries && list.begin(i) <= list.depth && left > 0; ++i) left *= list.through(i);
    return left;
}
