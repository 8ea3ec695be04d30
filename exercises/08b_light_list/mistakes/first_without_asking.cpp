// hint: past_the_end
// or: ends_at_the_point
// do ... while: the first entry is tested whether there is one or not.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    double left = 1;
    int i = 0;
    do left *= list.through(i++);
    while (left > 0 && i < list.entries && list.begin(i) <= list.depth);
    return left;
}
