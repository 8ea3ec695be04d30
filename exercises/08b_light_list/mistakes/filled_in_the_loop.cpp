// hint: filled_first
// Each turn asks whether the next entry is behind what fills the cell.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    double left = 1;
    for (int i = 0; i < list.entries && list.begin(i) <= list.depth && left > 0; ++i) {
        if (list.begin(i) > list.filled) return 0;
        left *= list.through(i);
    }
    return left;
}
