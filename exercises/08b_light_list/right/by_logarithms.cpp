// Adds up logarithms.
#include "raylab/accelerator/light_buffer/light_through_list.h"

#include <cmath>

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    double sum = 0;
    for (int i = 0; i < list.entries && list.begin(i) <= list.depth; ++i) {
        const double share = list.through(i);
        if (share <= 0) return 0;
        sum += std::log(share);
    }
    return std::exp(sum);
}
