#pragma once

#include "raylab/image/image.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/scene.h"

#include <array>
#include <string>
#include <vector>

namespace raylab::volumes {

/// What rays that come from everywhere see of an object and of the three bounds around it, in square metres: the mean of the
/// areas that they cast on a screen. (Weghorst, Hooper and Greenberg 1984 call the difference the void area.)
struct SeenAreas {
    double object, sphere, box, oriented_box;

    /// The share of the rays that a bound lets pass in vain.
    double empty(double bound) const { return 1 - object / bound; }
};

SeenAreas seen_areas(const Object& object, std::size_t rays, std::uint64_t seed);

/// A row for each object, by its material's name: how much of each bound is void.
std::vector<std::string> void_header();
std::vector<std::vector<std::string>> void_rows(const Scene& scene, const ChapterRun& run);

/// The scene in its objects' spheres, boxes and oriented boxes: the redder a pixel, the more of them it meets in vain.
Image void_picture(const Scene& scene, const ChapterRun& run);

}  // namespace raylab::volumes
