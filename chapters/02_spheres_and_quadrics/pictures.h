#pragma once

#include "raylab/experiment/ray_sphere/ray_sphere_methods.h"
#include "raylab/image/image.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/scene.h"

#include <functional>
#include <string>
#include <vector>

// The chapter's pictures, in the order of its story.

namespace raylab {

/// Behind everything.
inline const Color sky{0.82, 0.87, 0.92};

/// A picture, and the name of its figure.
struct Step {
    std::string name;
    std::function<Image()> make;
    Page::Keep keep = Page::Keep::picture;
};

/// The scene under its light, with shadows.
Image still_life(const Scene& scene, const ChapterRun& run);

/// The steps towards it: is something hit, how far away, which way does it face?
std::vector<Step> still_life_steps(const Scene& scene, const ChapterRun& run);

/// A unit sphere 4096 radii away: exactly, by the textbook's formula in float, where that formula is wrong, and by the
/// reformulated one.
std::vector<Step> far_sphere_steps(const ChapterRun& run);

/// A chequered floor that is a sphere of radius 1e7: by the textbook's formula in double and in float, and as a plane.
std::vector<Step> floor_steps(const ChapterRun& run);

/// Each surface of revolution alone, open and capped.
std::vector<Step> quadric_steps(const ChapterRun& run);

/// The still life's quadrics lit with their gradients as normals: as they are, and normalised.
std::vector<Step> gradient_steps(const Scene& scene, const ChapterRun& run);

}  // namespace raylab
