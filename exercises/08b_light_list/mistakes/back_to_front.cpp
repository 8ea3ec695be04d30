// hint: nearest_first
// The same by recursion: what lies deeper first.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    const auto behind = [&](const auto& self, int i) -> double {
        if (i >= list.entries || list.begin(i) > list.depth) return 1;
        const double left = self(self, i + 1);
        return left == 0 ? 0 : left * list.through(i);
    };
    return behind(behind, 0);
}
