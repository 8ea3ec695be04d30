// In long double, around the place.
#include "raylab/accelerator/item_buffer/drawn_depth.h"

std::optional<double> raylab::drawn_depth(const std::array<DrawnCorner, 3>& corners, double x, double y) {
    long double u[3], v[3], near[3], area[3];
    for (int i = 0; i < 3; ++i) {
        u[i] = static_cast<long double>(corners[static_cast<std::size_t>(i)].x) - x;
        v[i] = static_cast<long double>(corners[static_cast<std::size_t>(i)].y) - y;
        near[i] = 1.0L / corners[static_cast<std::size_t>(i)].depth;
    }
    long double sum = 0, mixed = 0;
    bool up = true, down = true;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        area[i] = u[j] * v[k] - v[j] * u[k];
        up = up && area[i] >= 0;
        down = down && area[i] <= 0;
        sum += area[i];
        mixed += area[i] * near[i];
    }
    if (up == down) return std::nullopt;
    return static_cast<double>(sum / mixed);
}
