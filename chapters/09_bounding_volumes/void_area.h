#pragma once

#include "raylab/image/image.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/scene.h"

#include <array>
#include <string>
#include <vector>

namespace raylab::volumes {

/// How large an object and the three bounds around it appear to rays from all directions, in square metres: the mean of
/// their projected areas. (Weghorst, Hooper and Greenberg 1984 call the difference the void area.)
struct SeenAreas {
    double object, sphere, box, oriented_box;

    /// The share of the rays that hit a bound but not the object.
    double empty(double bound) const { return 1 - object / bound; }
};

SeenAreas seen_areas(const Object& object, std::size_t rays, std::uint64_t seed);

/// A row for each object, by its material's name: the empty share of each bound.
std::vector<std::string> void_header();
std::vector<std::vector<std::string>> void_rows(const Scene& scene, const ChapterRun& run);

/// The kinds of bounding volumes.
enum class Volume { sphere, box, oriented_box };

/// The scene with its objects' bounding volumes: the more of them a pixel's rays hit in vain, the redder it is.
Image void_picture(const Scene& scene, Volume volume, const ChapterRun& run);

}  // namespace raylab::volumes
