#pragma once

#include "raylab/scene/scene.h"

#include <string>
#include <vector>

namespace raylab {

/// What POV-Ray is to be told beyond the scene.
struct PovOptions {
    int depth = 5;           // rays in a row, the eye ray included: max_trace_level
    double adc_bailout = 0;  // POV-Ray drops rays whose share of the pixel is below this; its own default is 1/255
};

/// The scene as POV-Ray 3.7 reads it, agreeing with Whitted's equation as far as POV-Ray can say it.
std::string to_pov(const Scene& scene, const PovOptions& options = {});

/// What POV-Ray will show otherwise, and why, one sentence each; empty: nothing that is known of. They stand at the top
/// of the exported text too.
std::vector<std::string> pov_differences(const Scene& scene);

}  // namespace raylab
