// hint: past_the_end
// Ends only at an entry that begins deeper.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    double left = 1;
    for (int i = 0; list.begin(i) <= list.depth && left > 0; ++i) left *= list.through(i);
    return left;
}
