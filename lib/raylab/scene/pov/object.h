#pragma once

#include "raylab/scene/scene.h"

#include <string>

namespace raylab::pov {

/// Declares what other parts of the text refer to: the texture of an invisible side, and the one that casts shadows.
std::string declared_textures();

/// Writes an object. One that transmits light gets a second object for its shadow, because the shadows of the lab are
/// opaque.
std::string object(const Object& object, const Scene& scene, const std::string& mesh_name);

/// Whether the object transmits light on a side that is visible.
bool is_translucent(const Object& object, const Scene& scene);

}  // namespace raylab::pov
