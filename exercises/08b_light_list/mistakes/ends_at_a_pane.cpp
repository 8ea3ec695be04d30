// hint: go_on_behind_glass
// The first thing that is hit says it all.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    for (int i = 0; i < list.entries && list.begin(i) <= list.depth; ++i)
        if (const double share = list.through(i); share < 1) return share;
    return 1;
}
