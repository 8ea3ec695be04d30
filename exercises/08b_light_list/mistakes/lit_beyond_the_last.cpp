// hint: what_is_left
// Says lit where the search comes to what is deeper than the point, whatever it went through.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    double left = 1;
    for (int i = 0; i < list.entries; ++i) {
        if (list.begin(i) > list.depth) return 1;
        left *= list.through(i);
        if (left == 0) return 0;
    }
    return left;
}
