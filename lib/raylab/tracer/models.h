#pragma once

#include "raylab/tracer/any_surface.h"
#include "raylab/tracer/listed_spheres.h"

// A picture is traced by the least of these that does it: chosen once, so that what a scene does not need costs its rays
// nothing, not even a question. Every model is compiled for every observer; there are no more of them than pay.

namespace raylab {

/// All of Whitted's method.
struct WhittedModel {
    using Surfaces = AnySurface;
    static constexpr bool feelers = true;    // shadow rays
    static constexpr bool recursion = true;  // reflected and transmitted rays, and the media they are in
};

/// No ray goes on from a surface, and none is felt for a light.
struct LocalLightModel {
    using Surfaces = AnySurface;
    static constexpr bool feelers = false;
    static constexpr bool recursion = false;
};

/// The same, and there are but a few spheres: the accelerator's seam and the questions which shape was met, and where a
/// transform has put it, take as long as all the rest.
struct LocalLightOnSpheres {
    using Surfaces = ListedSpheres;
    static constexpr bool feelers = false;
    static constexpr bool recursion = false;
};

}  // namespace raylab
