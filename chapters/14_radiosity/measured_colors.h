#pragma once

#include "raylab/scene/scene.h"

#include <string>
#include <vector>

// The colours of the Cornell box, from the spectra that were measured.

namespace raylab::cornell {

struct MeasuredColor {
    std::string name;  // the material's in scene.toml
    Color color;
};

/// The reflectance of each material as linear RGB, for a camera that is balanced to the box's light: each channel is
/// that of light which was reflected once, over that of the light itself. So a perfect white is (1, 1, 1).
std::vector<MeasuredColor> measured_reflectances();

/// The light's own colour as linear RGB before balancing, relative to its red.
Color measured_light();

/// Rows of the lesson's table: what was measured, as RGB, and what the scene has.
std::vector<std::string> color_header();
std::vector<std::vector<std::string>> color_rows(const Scene& scene);

}  // namespace raylab::cornell
