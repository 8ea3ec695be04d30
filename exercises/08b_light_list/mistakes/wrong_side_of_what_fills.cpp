// hint: before_what_fills
// or: filled_first
// The comparison is the wrong way round, and infinity is left out of it.
#include "raylab/accelerator/light_buffer/light_through_list.h"

#include <limits>

double raylab::light_through_list(const AskedLightList& list) {
    if (list.filled < std::numeric_limits<double>::infinity() && list.depth < list.filled) return 0;
    double left = 1;
    for (int i = 0; i < list.entries && list.begin(i) <= list.depth && left > 0; ++i) left *= list.through(i);
    return left;
}
