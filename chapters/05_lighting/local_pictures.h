#pragma once

#include "raylab/image/image.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/scene.h"
#include "raylab/tracer/whitted/whitted.h"

#include <memory>

// Pictures by the local model alone: every light counts, whatever is in front of it, and no ray is reflected or
// transmitted.

namespace raylab::lighting {

/// The scene at this size with its lighting; `options` may ask for more than the local model.
Image lit(const Scene& scene, ImageSize size, const ChapterRun& run,
          WhittedOptions options = {.shadows = WhittedOptions::Shadows::none});

/// The scene by what it shows without its lights: the background, what glows, and the ambient light.
Scene without_lights(const Scene& scene);
/// The scene by one of its lights and nothing else. These scenes and the one above add up to the whole one.
Scene by_light_alone(const Scene& scene, std::size_t light);

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
