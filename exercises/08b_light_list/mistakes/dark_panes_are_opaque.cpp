// hint: hardly_dark
// A pane that lets less than a twentieth through is taken for a board.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    double left = 1;
    for (int i = 0; i < list.entries && list.begin(i) <= list.depth; ++i) {
        const double share = list.through(i);
        if (share < 0.05) return 0;
        left *= share;
    }
    return left;
}
