#include "raylab/sampling/mapping/lens_point.h"

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const auto [x, y] = concentric_disk(u, v);
    return {radius * x, radius * y};
}
