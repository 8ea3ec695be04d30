// hint: glass_lets_through
// or: multiply
// Counts what is hit, and is dark if anything is.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    bool lit = true;
    for (int i = 0; i < list.entries; ++i) {
        if (list.begin(i) > list.depth) break;
        const double share = list.through(i);
        lit = lit && share == 1;
        if (share == 0) break;
    }
    return lit ? 1 : 0;
}
