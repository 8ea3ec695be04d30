#pragma once

#include "raylab/base/command_line.h"
#include "raylab/tracer/whitted.h"

// The options that `render` and `tree` share: how far Whitted's recursion goes, and by which models.

namespace raylab {

enum class RayRules {
    lab,
    spd,  // every ray that the surfaces ask for, whatever its weight; a light counts on their outer side
};

CommandLine with_whitted_options(CommandLine command_line);

WhittedOptions whitted_options(const Arguments& arguments, const Scene& scene, RayRules rules = RayRules::lab);

}  // namespace raylab
