// hint: miss_is_no_end
// The same: what misses the nearest thing misses all.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    double left = 1;
    int i = 0;
    while (i < list.entries && list.begin(i) <= list.depth) {
        const double share = list.through(i++);
        left = left * share;
        if (share == 1 || left == 0) return left;
    }
    return left;
}
