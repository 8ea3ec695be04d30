#pragma once

#include "raylab/base/command_line.h"

namespace raylab {

/// Refuses options of `raylab grade` that would do nothing in what is asked for, and says what does it.
void refuse_idle_options(const Arguments& arguments);

}  // namespace raylab
