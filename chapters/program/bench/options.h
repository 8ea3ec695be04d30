#pragma once

#include "raylab/base/command_line.h"

namespace raylab::bench {

/// What `raylab bench` takes: its program and the command that builds and runs it share it.
const CommandLine& command_line();

}  // namespace raylab::bench
