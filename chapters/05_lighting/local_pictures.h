#pragma once

#include "raylab/image/image.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/scene.h"
#include "raylab/tracer/whitted.h"

#include <memory>

// Pictures by the local model alone: every light counts wherever it is, and no ray goes on from what is seen.

namespace raylab::lighting {

/// The scene as it is lit; `options` may ask for more than the local model.
Image lit(const Scene& scene, const ChapterRun& run,
          WhittedOptions options = {.shadows = WhittedOptions::Shadows::none});

/// The scene by each of its lights alone, the ambient one first.
Image lights_apart(const Scene& scene, const ChapterRun& run);

/// A lamp over a wide floor under falloffs that are constant, linear, quadratic; all give the same at 2 metres.
Image falloffs(const ChapterRun& run);

/// A spot on a wall: uniform in its cone, cos^10, cos^60.
Image spots(const ChapterRun& run);

/// A ball by each term of Phong's model, and by their sum.
Image phong_terms(const ChapterRun& run);

/// A floor under a distant light: seen from where the eye is, and as if it were infinitely far.
Image viewers(const ChapterRun& run);

/// The same mesh with flat, Gouraud and Phong shading.
Image three_shadings(const std::shared_ptr<const Mesh>& mesh, const ChapterRun& run);

/// The scene by the local model, and with shadows cast: what is behind something is lit by the first.
Image local_and_shadowed(const Scene& scene, const ChapterRun& run);

}  // namespace raylab::lighting
