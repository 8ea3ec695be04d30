#pragma once

#include "picture_words.h"

#include "raylab/base/program.h"

namespace raylab {

/// `raylab render` of a scene whose model spreads rays. The picture on disk improves while it is made; an interrupt
/// leaves the last one, from which --resume goes on.
ExitCode render_transport(const Arguments& arguments, const AskedScene& asked, const std::vector<std::string>& words,
                          Outputs& outputs);

}  // namespace raylab
