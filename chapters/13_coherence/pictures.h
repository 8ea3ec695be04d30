#pragma once

#include "raylab/image/image.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/scene.h"

#include <string>
#include <vector>

namespace raylab::coherence {

/// The scene; its eye rays are answered by an item buffer, all others by a tree.
Image by_item_buffer(const Scene& scene, const ChapterRun& run);

/// How many pixels of the picture have other bits where a tree answers all rays.
std::vector<std::string> other_pixels_header();
std::vector<std::vector<std::string>> other_pixels_rows(const Scene& scene, const ChapterRun& run);

/// The first item of each pixel; each primitive has a colour of its own.
Image items(const Scene& scene, const ChapterRun& run);

/// The number of items kept for each pixel.
Image items_kept(const Scene& scene, const ChapterRun& run);

/// The sphere from far away, with the pixels marked where a z-buffer in floats has another triangle than the ray.
Image wrong_items(const ChapterRun& run);

}  // namespace raylab::coherence
