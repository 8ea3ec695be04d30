// hint: on_what_fills
// Lit are points before what fills the cell.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    const auto search = [&](const auto& self, int i) -> double {
        if (i == list.entries || list.begin(i) > list.depth) return 1;
        const double share = list.through(i);
        return share == 0 ? 0 : share * self(self, i + 1);
    };
    return list.depth < list.filled ? search(search, 0) : 0;
}
