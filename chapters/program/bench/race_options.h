#pragma once

#include "race.h"

#include "raylab/base/command_line.h"

namespace raylab::bench {

/// The options of a race, with `usual_peers` where no peer is named. It throws an Error for a wrong option, and for an
/// unknown mesh, kind of rays or peer, before anything is generated or built.
RaceOptions race_options(const Arguments& arguments, const std::vector<std::string>& usual_peers);

}  // namespace raylab::bench
