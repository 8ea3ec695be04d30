// hint: past_the_end
// i <= entries.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    double left = 1;
    for (int i = 0; i <= list.entries && left > 0; ++i) {
        if (list.begin(i) > list.depth) break;
        left *= list.through(i);
    }
    return left;
}
