#pragma once

#include "raylab/scene/scene.h"

#include <string>

// The renderers, which differ in how much they model. One is chosen for each picture by what its scene has
// (tracer/picture/models.h).

namespace raylab {

/// The simplest first.
enum class Renderer {
    local_light,   // eye rays only, which end where they hit a surface
    direct_light,  // ... and shadow rays from there
    whitted,       // ... and reflected and transmitted rays
};

/// What is asked of a picture in addition to eye rays.
struct PictureAsks {
    bool shadow_rays;
    int depth;  // of the ray tree; the eye ray has depth 1
};

/// The simplest renderer that draws a picture of the scene.
Renderer cheapest_renderer(const Scene& scene, const PictureAsks& picture);

/// The renderer's name and what it models, in words.
std::string name_of(Renderer renderer);
std::string in_words(Renderer renderer);

}  // namespace raylab
