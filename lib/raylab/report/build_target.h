#pragma once

#include "raylab/base/process.h"

#include <string>

namespace raylab {

/// Builds a target of the lab's build folder with ninja and returns ninja's result. It throws an Error where there is
/// no ninja, and where the build does not end within `timeout` seconds.
ProcessResult build_target(const std::string& target, double timeout = 120);

}  // namespace raylab
