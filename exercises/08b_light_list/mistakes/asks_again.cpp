// hint: once_each
// Tests once for the condition and once for the product.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    double left = 1;
    for (int i = 0; i < list.entries && list.begin(i) <= list.depth && left > 0; ++i)
        if (list.through(i) < 1) left *= list.through(i);
    return left;
}
