#pragma once

#include "raylab/base/command_line.h"
#include "raylab/base/memory_limit.h"

// The option --memory of all commands that read scenes, meshes and pictures.

namespace raylab {

CommandLine with_memory_option(CommandLine command_line);

MemoryLimit memory_limit(const Arguments& arguments);

/// Says on stderr what is about to take memory, and how much, where it is a megabyte or more.
void say_memory(const MemoryNeed& need);

}  // namespace raylab
