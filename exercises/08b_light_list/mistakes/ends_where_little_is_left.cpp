// hint: hardly_dark
// Ends the search where less than a hundredth is left, and keeps that.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    double left = list.depth > list.filled ? 0 : 1;
    int entry = 0;
    while (left > 0.01 && entry < list.entries && !(list.begin(entry) > list.depth)) left *= list.through(entry++);
    return left;
}
