#pragma once

#include "raylab/image/image.h"
#include "raylab/report/chapter.h"
#include "raylab/report/chart/chart.h"
#include "raylab/scene/scene.h"
#include "raylab/tracer/whitted/whitted.h"

// The chapter's pictures.

namespace raylab::recursion {

/// The three terms of Whitted's sum at each first hit, and the picture, which is their sum.
struct Terms {
    Image local, reflected, transmitted, sum;
};
Terms terms(const Scene& scene, const WhittedOptions& options, ImageSize size, const ChapterRun& run);

/// The number of rays of each pixel without shadow rays; black: 1, nearly white: 256 or more.
Image rays_picture(const Scene& scene, const WhittedOptions& options, ImageSize size, const ChapterRun& run);

/// Fresnel's reflectance against the angle, into glass and out of it, and Schlick's approximation of both.
CurveChart fresnel_chart();

}  // namespace raylab::recursion
