// Finds the end of what is in the way by halving, since asking for depths costs nothing.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    int low = 0, high = list.entries;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (list.begin(middle) <= list.depth)
            low = middle + 1;
        else
            high = middle;
    }
    double left = 1;
    for (int i = 0; i < low; ++i) {
        const double share = list.through(i);
        if (share == 0) return 0;
        left = left * share;
    }
    return left;
}
