#pragma once

#include "raylab/radiosity/hierarchical_scene.h"
#include "raylab/report/chapter_run.h"
#include "raylab/report/chart/chart.h"

// Hierarchical radiosity, shown.

namespace raylab::cornell {

/// The chapter's scene by links whose error is at most this share of the mean radiosity.
SceneHierarchy linked(const Scene& scene, double error, double edge, const ChapterRun& run);

/// The leaves, each in its own brightness and with an outline.
Image leaves_picture(const SceneHierarchy& solved, const Scene& scene, ImageSize size, const ChapterRun& run);

/// What one leaf of the floor, between both boxes, is linked to, itself or as a part of larger elements: each element
/// in a colour of its size, the leaf white.
Image links_picture(const SceneHierarchy& solved, const Scene& scene, ImageSize size, const ChapterRun& run);

/// Links and pairs of patches, as smaller and smaller elements are allowed.
CurveChart link_chart(const Scene& scene, const ChapterRun& run);

}  // namespace raylab::cornell
