#pragma once

#include "raylab/image/image.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/scene.h"
#include "raylab/tracer/shading/ray_start.h"

#include <string>
#include <vector>

// The chapter's pictures and the table of the flake, in the order of its story.

namespace raylab::shadows {

/// The scene under all its lights, with shadow rays.
Image shaded(const Scene& scene, const ChapterRun& run);

/// Ambient light alone, each light alone, and no shadows at all.
Image lights_apart(const Scene& scene, const ChapterRun& run);

/// A shadow ray's start under the microscope: the floats about a hit point, and where each way puts the start.
Image draw_starts();

/// The scene scaled about the origin and translated, with its camera and lights: the same picture in other numbers.
Scene elsewhere(const Scene& scene, double scale, const Vec3d& by);

/// A scene whose shadow rays start in this way.
Image with_shadows(const Scene& scene, const RayStart& start, const ChapterRun& run);

/// A sphere with nine on it, each with nine on it: they touch, and mirror each other. The text is in NFF.
std::string flake_nff(int levels);

/// The flake, with secondary rays that start in this way.
Image flake(const RayStart& start, const ChapterRun& run);

/// The number of rays traced for the flake, by the way they start.
std::vector<std::string> flake_header();
std::vector<std::vector<std::string>> flake_rows(const ChapterRun& run);

}  // namespace raylab::shadows
