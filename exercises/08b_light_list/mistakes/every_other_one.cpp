// hint: every_entry
// Counts on in the loop and in its head.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    double share = 1;
    for (int i = 0; i < list.entries && share > 0 && list.begin(i) <= list.depth; ++i) share *= list.through(i++);
    return share;
}
