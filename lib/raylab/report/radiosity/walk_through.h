#pragma once

#include "raylab/report/radiosity/solved_scene.h"
#include "raylab/scene/scene.h"

#include <string>

namespace raylab {

/// A page in which one walks through a solved scene, complete in itself: three.js, its licence, the mesh and its light
/// are inside, so it works from a file and without a network. The exposure is where its slider begins. It throws an
/// Error where three.js, which is Debian's package libjs-three, is no longer where it was when raylab was built.
std::string walk_through_page(const SolvedScene& solved, const Camera& camera, const std::string& title,
                              double exposure);

}  // namespace raylab
