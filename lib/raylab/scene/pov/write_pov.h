#pragma once

#include "raylab/scene/scene.h"

#include <string>
#include <vector>

namespace raylab {

/// What POV-Ray has to be told in addition to the scene.
struct PovOptions {
    int depth = 5;           // the longest path of rays, with the eye ray: max_trace_level
    double adc_bailout = 0;  // POV-Ray drops rays whose weight in the pixel is below this; its own default is 1/255
    int samples = 64;        // eye rays through a lens, or points of an area light: each pixel has all of them
};

/// The scene in the language of POV-Ray 3.7. The picture agrees with Whitted's equation as far as POV-Ray can express
/// it; in the other models, lenses and what emits are its focal blur and its area lights.
std::string to_pov(const Scene& scene, const PovOptions& options = {});

/// The differences that POV-Ray's picture will have, and why, in one sentence each; empty where none is known. They are
/// also listed at the top of the exported text.
std::vector<std::string> pov_differences(const Scene& scene);

}  // namespace raylab
