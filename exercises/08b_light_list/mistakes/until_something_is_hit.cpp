// hint: go_on_behind_glass
// Goes on only while nothing is hit.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    double left = 1;
    int i = 0;
    while (left == 1 && i < list.entries && list.begin(i) <= list.depth) left *= list.through(i++);
    return left;
}
