#pragma once

#include "race.h"

#include "raylab/base/command_line.h"

namespace raylab::bench {

/// What is to be raced, where nothing is said of peers `usual_peers`. Error where a word is refused or a mesh, a kind
/// of rays or a peer has a name that nobody has: nothing is made or built for that.
RaceOptions race_options(const Arguments& arguments, const std::vector<std::string>& usual_peers);

}  // namespace raylab::bench
