#pragma once

#include "raylab/tracer/shading/any_surface.h"

// A picture is traced by the least of these that draws it, chosen once: what a scene does not need costs its rays
// nothing, not even a question. Every model is compiled for every observer, so there are no more of them than pay.

namespace raylab {

/// All of Whitted's method.
struct WhittedModel {
    using Surfaces = PreparedSurfaces;
    static constexpr bool shadow_rays = true;  // shadow rays
    static constexpr bool recursion = true;    // reflected and transmitted rays
    static constexpr bool media = true;        // transparent surfaces, and what lies between them
};

/// The same for one ray, which no surface is prepared for.
struct OneRay : WhittedModel {
    using Surfaces = AnySurface;
};

/// No ray goes on from a surface, but shadow rays are cast.
struct DirectLightModel {
    using Surfaces = PreparedSurfaces;
    static constexpr bool shadow_rays = true;
    static constexpr bool recursion = false;
    static constexpr bool media = false;
};

/// Eye rays alone.
struct LocalLightModel : DirectLightModel {
    static constexpr bool shadow_rays = false;
};

}  // namespace raylab
