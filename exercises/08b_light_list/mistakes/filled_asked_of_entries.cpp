// hint: filled_first
// Asks for what fills the cell at each entry: of an empty list it never asks.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    double left = 1;
    for (int i = 0; i < list.entries && left > 0; ++i) {
        if (list.depth > list.filled) left = 0;
        if (left == 0 || list.begin(i) > list.depth) break;
        left *= list.through(i);
    }
    return left;
}
