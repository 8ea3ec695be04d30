// hint: every_entry
// Finds the end by halving. The search begins with the last number for the end, which should be one more.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    int low = 0, high = list.entries - 1;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (list.begin(middle) <= list.depth)
            low = middle + 1;
        else
            high = middle;
    }
    double left = 1;
    for (int i = 0; i < low; ++i) {
        left *= list.through(i);
        if (left == 0) return 0;
    }
    return left;
}
