// The other way round: how much is held back.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    double held_back = 0;
    int i = 0;
    while (i != list.entries && list.begin(i) <= list.depth) {
        const double share = list.through(i++);
        if (share == 0) return 0;
        held_back = 1 - (1 - held_back) * share;
    }
    return 1 - held_back;
}
