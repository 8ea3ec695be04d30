#pragma once

#include "raylab/scene/scene.h"

#include <string>

namespace raylab::pov {

/// What other texts refer to: a side nobody sees, and what stops light.
std::string declared_textures();

/// An object, and beside it, where light passes it, its shadow: ours are of opaque shadows.
std::string object(const Object& object, const Scene& scene, const std::string& mesh_name);

/// Whether the object lets light through on a side that is seen.
bool is_translucent(const Object& object, const Scene& scene);

}  // namespace raylab::pov
