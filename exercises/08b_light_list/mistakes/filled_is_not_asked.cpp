// hint: filled_first
// Whatever fills the cell is in the list, too.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    double left = 1;
    for (int i = 0; i < list.entries && list.begin(i) <= list.depth && left > 0; ++i) left *= list.through(i);
    return left;
}
