#pragma once

#include "raylab/image/image.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/scene.h"
#include "raylab/tracer/whitted/whitted.h"

#include <string>
#include <vector>

// The chapter's pictures and the table of the flake, in the order of its story.

namespace raylab::shadows {

/// The scene scaled about the origin and translated, with its camera and lights: the same picture in other numbers.
Scene elsewhere(const Scene& scene, double scale, const Vec3d& by);

/// A ball of few triangles with interpolated normals, under a light from the side: by shadow rays, or by none.
Image coarse_ball(WhittedOptions::Shadows shadows, const ChapterRun& run);

/// A sphere with nine on it, each with nine on it: they touch, and mirror each other. The text is in NFF.
std::string flake_nff(int levels);

/// The same with four generations, to be looked at.
Image sphereflake(const ChapterRun& run);

/// One shadow ray's start, step by step: the hit point of a ray in floats, put back on its surface, and beside it.
std::vector<std::vector<std::string>> worked_start_rows(const Scene& scene);

/// The number of rays traced for the flake, by the way they start.
std::vector<std::string> flake_header();
std::vector<std::vector<std::string>> flake_rows(const ChapterRun& run);

}  // namespace raylab::shadows
