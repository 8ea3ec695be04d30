// hint: multiply
// The mean of all in the way.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    double sum = 0;
    int tested = 0;
    for (; tested < list.entries && list.begin(tested) <= list.depth; ++tested) {
        const double share = list.through(tested);
        if (share == 0) return 0;
        sum += share;
    }
    return tested > 0 ? sum / tested : 1;
}
