// What one entry lets through of what all that follow let through.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    const auto through_from = [&](const auto& self, int i) -> double {
        if (i == list.entries || list.begin(i) > list.depth) return 1;
        const double share = list.through(i);
        return share > 0 ? share * self(self, i + 1) : 0;
    };
    return list.filled < list.depth ? 0 : through_from(through_from, 0);
}
