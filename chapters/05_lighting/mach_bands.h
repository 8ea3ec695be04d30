#pragma once

#include "raylab/image/image.h"
#include "raylab/report/chapter.h"

namespace raylab::lighting {

/// A coarse sphere with flat, Gouraud and Phong shading, and below each its brightness along the line across it, with
/// that of the exact sphere: flat shading has steps, Gouraud's has kinks.
Image draw_mach_bands(const ChapterRun& run);

/// The largest jump of the brightness from one point to the next along that line, and the largest change of its slope
/// from point to point, for the methods of shading_methods().
struct Roughness {
    std::string method;
    double jump, kink;
};
std::vector<Roughness> roughness_along_line();

}  // namespace raylab::lighting
