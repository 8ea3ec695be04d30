// hint: ends_at_the_point
// A small number is added to the depth, to be safe.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    double share = 1;
    for (int i = 0; i < list.entries && share > 0 && list.begin(i) <= list.depth + 1e-3; ++i) share *= list.through(i);
    return share;
}
