// hint: hardly_dark
// A tenth of the light is taken for none.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.filled < list.depth) return 0;
    double share = 1;
    for (int i = 0; i != list.entries; ++i) {
        if (list.depth < list.begin(i)) break;
        share = share * list.through(i);
        if (share < 0.1) return 0;
    }
    return share;
}
