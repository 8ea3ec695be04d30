// hint: multiply
// Takes away what each holds back.
#include "raylab/accelerator/light_buffer/light_through_list.h"

#include <algorithm>

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    double left = 1;
    for (int i = 0; i < list.entries && list.begin(i) <= list.depth; ++i) {
        const double share = list.through(i);
        left -= 1 - share;
        if (share == 0) return 0;
    }
    return std::max(left, 0.0);
}
