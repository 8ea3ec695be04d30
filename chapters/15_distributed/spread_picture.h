#pragma once

#include "raylab/report/chapter_run.h"
#include "raylab/sampling/pixel_filter.h"
#include "raylab/scene/scene.h"
#include "raylab/transport/path/transport_picture.h"

#include <string>

namespace raylab::spread {

/// How the samples of a picture are taken.
struct Samples {
    Sampler sampler = {.kind = SamplerKind::sobol, .count = 32};
    PixelFilter filter = PixelFilter::box;
    TransportOptions options = {};
};

/// Rays are followed as Kajiya has it.
inline TransportOptions paths() { return {.followed = Followed::all}; }

/// The scene at a size, by rays that spread. In a quick run a pixel has at most four samples.
Image spread_picture(const Scene& scene, ImageSize size, const Samples& samples, const ChapterRun& run);

/// How many samples each pixel gets where they are spent adaptively, 32 on the average: dark 4, bright 128 and more.
Image sample_counts(const Scene& scene, ImageSize size, const ChapterRun& run);

/// One of the chapter's small scenes: scenes/NAME.toml.
Scene scene_named(const std::string& name);

}  // namespace raylab::spread
