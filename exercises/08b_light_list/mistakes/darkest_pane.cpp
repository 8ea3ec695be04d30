// hint: multiply
// The least share.
#include "raylab/accelerator/light_buffer/light_through_list.h"

#include <algorithm>

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    double left = 1;
    for (int i = 0; i < list.entries && list.begin(i) <= list.depth && left > 0; ++i)
        left = std::min(left, list.through(i));
    return left;
}
