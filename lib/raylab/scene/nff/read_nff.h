#pragma once

#include "raylab/scene/scene.h"

#include <string>
#include <string_view>

namespace raylab {

/// A scene in Haines' Neutral File Format, version 3.1.
Scene read_nff(std::string_view text, const std::string& file);

}  // namespace raylab
