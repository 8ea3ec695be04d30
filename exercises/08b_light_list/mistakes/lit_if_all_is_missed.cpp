// hint: glass_lets_through
// or: go_on_behind_glass
// Goes on as long as entries are missed. The point is lit if that leads beyond all that is in the way.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    const auto is_in_the_way = [&](int i) { return i < list.entries && list.begin(i) <= list.depth; };
    int missed = 0;
    while (list.depth <= list.filled && is_in_the_way(missed) && list.through(missed) == 1) ++missed;
    return list.depth > list.filled || is_in_the_way(missed) ? 0 : 1;
}
