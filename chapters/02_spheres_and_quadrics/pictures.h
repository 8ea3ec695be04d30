#pragma once

#include "raylab/geometry/ray_sphere_methods.h"
#include "raylab/image/image.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/scene.h"

#include <string>
#include <vector>

// The chapter's pictures, in the order of its story.

namespace raylab {

/// A picture, the file that it goes to and what it shows.
struct Step {
    std::string file, caption;
    Image image;
};

/// The scene, decided exactly, under a lamp.
Step still_life(const Scene& scene, const ChapterRun& run);

/// On the way there: is something hit, how far, which way does it face?
std::vector<Step> still_life_steps(const Scene& scene, const ChapterRun& run);

/// A unit sphere 4096 radii away: exactly, by the school formula in float, where that one is wrong, reformulated.
std::vector<Step> far_sphere_steps(const ChapterRun& run);

/// A chequered floor that is a sphere of radius 1e7: by the school formula in double and in float, and as a plane.
std::vector<Step> floor_steps(const ChapterRun& run);

/// Each surface of revolution alone, open and capped.
std::vector<Step> quadric_steps(const ChapterRun& run);

/// The still life's quadrics lit with their gradients: as they are, and normalised.
std::vector<Step> gradient_steps(const Scene& scene, const ChapterRun& run);

}  // namespace raylab
