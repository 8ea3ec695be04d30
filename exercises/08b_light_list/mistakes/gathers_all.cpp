// hint: dark_is_dark
// Gathers the shares, then multiplies them.
#include "raylab/accelerator/light_buffer/light_through_list.h"

#include <numeric>
#include <vector>

double raylab::light_through_list(const AskedLightList& list) {
    if (list.depth > list.filled) return 0;
    std::vector<double> shares;
    for (int i = 0; i < list.entries; ++i) {
        if (list.begin(i) > list.depth) break;
        shares.push_back(list.through(i));
    }
    return std::accumulate(shares.begin(), shares.end(), 1.0, [](double a, double b) { return a * b; });
}
