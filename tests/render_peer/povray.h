#pragma once

#include "raylab/image/image.h"
#include "raylab/scene/pov/write_pov.h"

#include <optional>

/// The scene as POV-Ray renders it; absent, with a message, where there is no POV-Ray.
std::optional<raylab::Image> povray_picture(const raylab::Scene& scene, const raylab::PovOptions& options = {});
