// hint: hardly_dark
// Less than a hundredth is none.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    double left = 1;
    for (int i = 0; i < list.entries && list.begin(i) <= list.depth; ++i) {
        left *= list.through(i);
        if (left < 0.01) return 0;
    }
    return left;
}
