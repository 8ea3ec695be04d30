#pragma once

#include "raylab/accelerator/light_buffer/light_lists.h"
#include "raylab/image/image.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/scene.h"

#include <array>

// The lesson's rendered pictures, in its order.

namespace raylab::lantern {

/// The size of pictures that stand side by side.
ImageSize beside(const ChapterRun& run);

/// The scene, with its shadow rays through a light buffer.
Image shaded(const Scene& scene, ImageSize size, const LightBufferOptions& options, const ChapterRun& run);

/// The six faces of the light's cube, unfolded: the scene as seen from the light.
Image seen_by_light(const Scene& scene, const ChapterRun& run);

/// The number of primitives that each cell lists, on the unfolded cube.
Image cell_lists(const Scene& scene, int resolution, const ChapterRun& run);

/// Tests of boxes and primitives for the shadow rays of each pixel: through a tree, and through a light buffer; in the
/// same colours.
std::array<Image, 2> shadow_ray_costs(const Scene& scene, const ChapterRun& run);

}  // namespace raylab::lantern
