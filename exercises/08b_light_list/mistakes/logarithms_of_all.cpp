// hint: ends_at_the_point
// Adds up logarithms of all entries, before the point and beyond it.
#include "raylab/accelerator/light_buffer/light_through_list.h"

#include <cmath>

double raylab::light_through_list(const AskedLightList& list) {
    if (list.filled < list.depth) return 0;
    double sum = 0;
    for (int i = 0; i != list.entries; ++i) {
        const double share = list.through(i);
        if (share <= 0) return 0;
        sum += std::log(share);
    }
    return std::exp(sum);
}
