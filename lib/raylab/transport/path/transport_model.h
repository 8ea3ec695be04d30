#pragma once

#include "raylab/tracer/shading/any_surface.h"
#include "raylab/transport/lobe/material_lobes.h"

namespace raylab {

/// What spread rays know of a scene. All pictures are made by this model; tests/bench/needs measures what each part
/// costs a scene that does not need it, by models that lack it.
struct TransportModel {
    using Surfaces = PreparedSurfaces;
    using Lobes = MaterialLobes;
    static constexpr bool lens = true, time = true, area_lights = true;

    static Lobes lobes(const Material& material, const Color& diffuse, const Vec3d& wo, const Interface& interface,
                       FacetShares shares) {
        return material_lobes(material, diffuse, wo, interface, shares);
    }
};

}  // namespace raylab
