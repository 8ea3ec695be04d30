#pragma once

#include "raylab/image/image.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/scene.h"
#include "raylab/tracer/ray_start.h"

#include <string>
#include <vector>

// The chapter's pictures and the table of the flake, in the order of its story.

namespace raylab::shadows {

/// The scene under all its lamps, feelers cast.
Image shaded(const Scene& scene, const ChapterRun& run);

/// Ambient light alone, each lamp alone, and no shadows at all.
Image lamps_apart(const Scene& scene, const ChapterRun& run);

/// A feeler's start under the microscope: the floats about a hit point, and where each way puts the start.
Image draw_starts();

/// The scene scaled about the origin and moved, camera and lamps with it: the same picture, in other numbers.
Scene elsewhere(const Scene& scene, double scale, const Vec3d& by);

/// ... with feelers that start like that.
Image felt(const Scene& scene, const RayStart& start, const ChapterRun& run);

/// A sphere with nine on it, each with nine on it: they touch, and mirror one another. As an NFF file would have it.
std::string flake_nff(int levels);

/// The flake with secondary rays started so.
Image flake(const RayStart& start, const ChapterRun& run);

/// Rays traced for the flake, by the way they start.
std::vector<std::string> flake_header();
std::vector<std::vector<std::string>> flake_rows(const ChapterRun& run);

}  // namespace raylab::shadows
