#pragma once

#include "raylab/image/image.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/scene.h"

#include <memory>

// Pictures by the local model alone: every light counts, whatever is in front of it, and no ray is reflected or
// transmitted.

namespace raylab::lighting {

Image lit(const Scene& scene, ImageSize size, const ChapterRun& run);

/// A light over a wide floor with a falloff that is constant, linear, quadratic; all are equal at 2 metres.
Image falloffs(const ChapterRun& run);

/// A spotlight on a wall: uniform in its cone, cos^10, cos^60.
Image spots(const ChapterRun& run);

/// A sphere with each term of Phong's model, and with their sum.
Image phong_terms(const ChapterRun& run);

/// A floor under a distant light: with the viewer where the eye is, and as if it were infinitely far away.
Image viewers(const ChapterRun& run);

/// The same mesh with flat, Gouraud and Phong shading.
Image three_shadings(const std::shared_ptr<const Mesh>& mesh, const ChapterRun& run);

}  // namespace raylab::lighting
