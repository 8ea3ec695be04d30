#pragma once

#include "raylab/report/chapter_run.h"
#include "raylab/scene/scene.h"
#include "raylab/tracer/picture/eye_picture.h"
#include "raylab/tracer/whitted/whitted.h"

namespace raylab {

/// The rays of a chapter's picture: jittered, `per_side` squared a pixel, and one in a quick run.
EyePictureOptions chapter_rays(const ChapterRun& run, int per_side = 3);

/// The scene at a size, as its camera sees it.
Image chapter_picture(const Scene& scene, ImageSize size, const ChapterRun& run, const WhittedOptions& options = {});

}  // namespace raylab
