// hint: ends_at_the_point
// Asks where an entry begins after it has tested it.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    double left = 1;
    for (int i = 0; i < list.entries; ++i) {
        left *= list.through(i);
        if (left == 0 || list.begin(i) > list.depth) break;
    }
    return left;
}
