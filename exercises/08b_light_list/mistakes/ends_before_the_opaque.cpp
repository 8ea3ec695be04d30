// hint: opaque_is_dark
// Ends at what is opaque, and gives what came before it.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    double share = 1;
    for (int i = 0; i < list.entries && list.begin(i) <= list.depth; ++i) {
        const double passes = list.through(i);
        if (passes == 0) break;
        share *= passes;
    }
    return share;
}
