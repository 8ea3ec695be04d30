#pragma once

#include "raylab/tracer/any_surface.h"

// A picture is traced by the least of these that does it or, where all is plain, by plain_tracer.h: chosen once, so that what
// a scene does not need costs its rays nothing, not even a question. Every model is compiled for every observer; there are no more of them than pay.

namespace raylab {

/// All of Whitted's method.
struct WhittedModel {
    using Surfaces = PreparedSurfaces;
    static constexpr bool feelers = true;    // shadow rays
    static constexpr bool recursion = true;  // reflected and transmitted rays, and the media they are in
};

/// The same for one ray, which no surface is prepared for.
struct OneRay : WhittedModel {
    using Surfaces = AnySurface;
};

/// No ray goes on from a surface, and none is felt for a light.
struct LocalLightModel {
    using Surfaces = PreparedSurfaces;
    static constexpr bool feelers = false;
    static constexpr bool recursion = false;
};

}  // namespace raylab
