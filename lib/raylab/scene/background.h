#pragma once

#include "raylab/scene/scene.h"

namespace raylab {

/// The colour of a sky where the sine of the elevation is `rise`: the horizon's on it and below, the zenith's straight
/// up, and between them more of the zenith's the higher, most quickly near the horizon, where a real sky is hazy. The
/// fourth power was chosen by looks.
Color sky_color(const Color& horizon, const Color& zenith, double rise);

/// What a ray in this direction, of any length, brings if it hits nothing.
inline Color background_color(const Background& background, const Vec3f& direction) {
    if (!background.zenith) return background.color;
    const Vec3d d = convert<double>(direction);
    return sky_color(background.color, *background.zenith, d.y / glm::length(d));
}

/// Whether it sends any light from where rays hit nothing.
inline bool sends_light(const Background& background) {
    constexpr Color black{0, 0, 0};
    return background.color != black || background.zenith.value_or(black) != black;
}

}  // namespace raylab
