// hint: weights
// Each corner is weighted by the area over the edge from it to the next one, which is the weight of the third.
#include "raylab/accelerator/item_buffer/drawn_depth.h"

std::optional<double> raylab::drawn_depth(const std::array<DrawnCorner, 3>& corners, double x, double y) {
    double sum = 0, mixed = 0;
    bool up = true, down = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const DrawnCorner &here = corners[i], &next = corners[(i + 1) % 3];
        const double weight = (here.x - x) * (next.y - y) - (here.y - y) * (next.x - x);
        up = up && weight >= 0;
        down = down && weight <= 0;
        sum += weight;
        mixed += weight / here.depth;
    }
    if (up == down || sum == 0) return std::nullopt;
    return sum / mixed;
}
