#include "raylab/scene/background.h"

namespace raylab {

Color sky_color(const Color& horizon, const Color& zenith, double rise) {
    if (!(rise > 0)) return horizon;
    const double below = rise < 1 ? 1 - rise : 0, haze = below * below * below * below;
    return haze * horizon + (1 - haze) * zenith;
}

}  // namespace raylab
