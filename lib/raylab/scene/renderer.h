#pragma once

#include "raylab/scene/scene.h"

#include <string>

// How much of a renderer a picture takes: it is chosen once, for what the scene has (tracer/models.h).

namespace raylab {

/// The least first.
enum class Renderer {
    local_light,   // eye rays, which end where they hit a surface
    direct_light,  // ... and shadow rays from there
    whitted,       // ... and reflected and transmitted rays
};

/// What a picture asks for besides eye rays.
struct PictureAsks {
    bool shadow_rays;
    int depth;  // of the ray tree; the eye ray has depth 1
};

/// The least that draws a picture of the scene.
Renderer least_renderer(const Scene& scene, const PictureAsks& picture);

/// Its name and what it does, in words.
std::string name_of(Renderer renderer);
std::string in_words(Renderer renderer);

}  // namespace raylab
