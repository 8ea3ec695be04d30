#pragma once

#include "raylab/tracer/shading/illumination.h"

#include <vector>

namespace raylab {

/// A material and what it shows by itself.
struct Finish : Material {
    Color unlit{0, 0, 0};  // without any light but the ambient: its emission, and that light's share
};

/// The lights and materials of a scene, made ready for a picture: what no ray changes is computed once.
struct Lighting {
    explicit Lighting(const Scene& scene);

    std::vector<ShadingLight> lights;
    std::vector<Finish> finishes;  // in the order of the scene's materials
};

}  // namespace raylab
