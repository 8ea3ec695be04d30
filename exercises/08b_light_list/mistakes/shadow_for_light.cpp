// hint: held_back
// Gathers shadow.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 1;
    double shadow = 0;
    for (int i = 0; i < list.entries; ++i) {
        if (list.begin(i) > list.depth) break;
        shadow += (1 - shadow) * (1 - list.through(i));
        if (shadow == 1) break;
    }
    return shadow;
}
