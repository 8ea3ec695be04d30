// hint: filled_first
// Asks at the end.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    double left = 1;
    for (int i = 0; i < list.entries; ++i) {
        if (list.begin(i) > list.depth) break;
        left *= list.through(i);
        if (left == 0) return 0;
    }
    return list.depth > list.filled ? 0 : left;
}
