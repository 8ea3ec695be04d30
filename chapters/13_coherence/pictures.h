#pragma once

#include "raylab/image/image.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/scene.h"

namespace raylab::coherence {

/// The scene, its eye rays answered by an item buffer, all others by a tree.
Image by_item_buffer(const Scene& scene, const ChapterRun& run);

/// How many pixels of the same picture are other bits where a tree answers all rays.
std::size_t other_pixels(const Scene& scene, const Image& picture, const ChapterRun& run);

/// The first item of each pixel, each primitive in a colour of its own.
Image items(const Scene& scene, const ChapterRun& run);

/// How many items are kept for each pixel.
Image items_kept(const Scene& scene, const ChapterRun& run);

/// The ball from far away, with the pixels where a z-buffer in floats has another triangle than the ray.
Image wrong_items(const ChapterRun& run);

}  // namespace raylab::coherence
