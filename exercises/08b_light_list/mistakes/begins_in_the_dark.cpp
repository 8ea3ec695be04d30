// hint: begins_with_one
// or: dark_is_dark
// A product that begins with 0.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    double share = 0;
    for (int i = 0; i < list.entries && list.begin(i) <= list.depth; ++i) share *= list.through(i);
    return share;
}
