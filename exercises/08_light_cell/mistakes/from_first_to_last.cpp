// hint: last_number
// or: rounded
// Mixes the first number and the last one by the place.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <algorithm>
#include <cmath>

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    const double x = direction.x, y = direction.y, z = direction.z;
    const auto on = [&](int face, double w, double u, double v) {
        const auto number = [&](double across) {
            const double share = 0.5 + across / w / 2;
            return static_cast<int>(std::lerp(0.0, resolution - 1.0, share));
        };
        return LightCell{face, number(u), number(v)};
    };
    const double a = std::abs(x), b = std::abs(y), c = std::abs(z);
    if (a >= b && a >= c) return on(x < 0 ? 1 : 0, a, y, z);
    if (b >= c) return on(y < 0 ? 3 : 2, b, z, x);
    return on(z < 0 ? 5 : 4, c, x, y);
}
