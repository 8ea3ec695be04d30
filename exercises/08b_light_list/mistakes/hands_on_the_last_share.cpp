// hint: multiply
// By recursion. Each call hands on the share of its own entry, and not what is left of what it was given.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    const auto behind = [&](const auto& self, int i, double left) -> double {
        if (left == 0 || i == list.entries || list.begin(i) > list.depth) return left;
        return self(self, i + 1, list.through(i));
    };
    return list.depth > list.filled ? 0 : behind(behind, 0, 1);
}
