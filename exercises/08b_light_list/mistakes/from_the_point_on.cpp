// hint: nearest_first
// From the last entry in the way back to the light.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    int end = list.entries;
    while (end > 0 && list.begin(end - 1) > list.depth) --end;
    double left = 1;
    while (end > 0 && left > 0) left *= list.through(--end);
    return left;
}
