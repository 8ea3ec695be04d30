// hint: hardly_dark
// In 256 steps, down to 0.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    double left = 1;
    for (int i = 0; i < list.entries && list.begin(i) <= list.depth && left > 0; ++i) left *= list.through(i);
    return left < 1.0 / 256 ? 0 : left;
}
