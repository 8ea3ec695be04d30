#pragma once

#include "raylab/scene/scene.h"

#include <optional>
#include <string>
#include <string_view>

namespace raylab {

/// The word in scene files and options: "auto", "whitted", "distributed", "path".
std::string to_string(RenderModel model);

/// The way back; absent: no such word.
std::optional<RenderModel> render_model(std::string_view word);

/// The model that draws the scene: what it asks for, or where that is automatic, `distributed` for a lens, for motion
/// while a shutter is open, for gloss, roughness and emission, otherwise `whitted`.
RenderModel chosen_model(const Scene& scene);

}  // namespace raylab
