#pragma once

#include "raylab/scene/scene.h"

#include <string>

// How much of a renderer a picture takes: it is chosen once, for what the scene has (tracer/models.h).

namespace raylab {

/// The least first.
enum class Renderer {
    plain_spheres,  // ... and a list of plain spheres in the light of points is all that there is
    local_light,    // every ray ends where it meets a surface, and none is felt for a light
    whitted,        // reflected and transmitted rays, and feelers
};

/// What a picture asks for besides eye rays.
struct PictureAsks {
    bool feelers;            // to lights
    int depth;               // of the ray tree; the eye ray has depth 1
    bool usual_look = true;  // highlights are seen from the eye, and light counts on the side that it looks at
};

/// What finds hits.
enum class FoundBy { list, other };

/// The least that draws a picture of the scene.
Renderer least_renderer(const Scene& scene, const PictureAsks& picture, FoundBy found_by);

/// Its name and what it does, in words.
std::string name_of(Renderer renderer);
std::string in_words(Renderer renderer);

}  // namespace raylab
