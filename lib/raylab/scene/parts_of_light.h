#pragma once

#include "raylab/scene/scene.h"

#include <cstddef>

// A scene by a part of its light. Light adds up: the pictures of a scene without its lights and by each of them alone
// have the picture of the whole scene as their sum, where no ray is cut for the little that it carries.

namespace raylab {

/// The scene by what it shows without its lights: the background, what glows, and the ambient light.
Scene without_lights(const Scene& scene);

/// The scene by one of its lights and nothing else.
Scene by_light_alone(const Scene& scene, std::size_t light);

}  // namespace raylab
