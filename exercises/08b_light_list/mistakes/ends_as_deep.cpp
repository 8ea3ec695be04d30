// hint: as_deep
// Ends at an entry that begins as deep, by a search for it.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    int end = 0;
    while (end < list.entries && list.begin(end) < list.depth) ++end;
    double left = 1;
    for (int i = 0; i < end; ++i)
        if ((left *= list.through(i)) == 0) return 0;
    return left;
}
