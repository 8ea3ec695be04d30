// hint: hardly_dark
// Ends the search by an epsilon.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    constexpr double epsilon = 1e-6;
    double share = list.depth > list.filled ? 0 : 1;
    for (int i = 0; i < list.entries; ++i) {
        if (share < epsilon || list.begin(i) > list.depth) break;
        share *= list.through(i);
    }
    return share < epsilon ? 0 : share;
}
