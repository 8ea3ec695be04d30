// Goes through all numbers and tests those that are in the way.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    double left = list.depth <= list.filled ? 1 : 0;
    for (int i = 0; i < list.entries; ++i)
        if (left != 0 && !(list.begin(i) > list.depth)) left *= list.through(i);
    return left;
}
