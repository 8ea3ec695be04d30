// hint: every_entry
// or: past_the_end
// The first entry has the number 1.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    double left = 1;
    for (int i = 1; i < list.entries; ++i) {
        if (list.begin(i) > list.depth) break;
        left *= list.through(i);
        if (left == 0) break;
    }
    return left;
}
