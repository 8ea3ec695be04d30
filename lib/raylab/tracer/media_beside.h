#pragma once

#include "raylab/tracer/media.h"
#include "raylab/tracer/place.h"

namespace raylab {

/// The media on both sides of a transparent surface.
struct Beside {
    Media before, behind;
};

/// Before is where the ray comes from, in these media. Who leaves what was never entered has been inside from the start.
inline Beside media_beside(const Place& place, const Media& media) {
    const Object* object = place.at.object;
    if (place.front) return {media, media.entered(object)};
    const Media inside = media.contains(object) ? media : media.entered(object);
    return {inside, inside.left(object)};
}

}  // namespace raylab
