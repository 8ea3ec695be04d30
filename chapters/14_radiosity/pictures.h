#pragma once

#include "raylab/radiosity/scene_radiosity.h"
#include "raylab/report/chapter_run.h"

#include <array>
#include <string>
#include <vector>

// The Cornell box, solved and shown.

namespace raylab::cornell {

/// The chapter's scene, solved with about this many patches.
SceneRadiosity solved(const Scene& scene, std::size_t patches, const ChapterRun& run);

/// Its picture.
Image shown(const SceneRadiosity& solved, const Scene& scene, ImageSize size, RadiosityShading shading,
            const ChapterRun& run);

/// The same where only these radiosities are known.
Image shown(const SceneRadiosity& solved, const Radiosities& radiosity, const Scene& scene, ImageSize size,
            const ChapterRun& run);

/// The page in which one walks through it.
std::string walk_through_box(const SceneRadiosity& solved, const Scene& scene);

/// What light shows that was reflected once: each patch's emission, and its share of what emitters send there.
Radiosities after_one_reflection(const SceneRadiosity& solved);

/// The radiosities after 1, 2, 10 and 100 shots.
std::array<Radiosities, 4> after_shots(const SceneRadiosity& solved);

/// The form factors as a picture: row i is what patch i sees, white the largest, each tenth part of it a third darker.
Image matrix_picture(const SceneRadiosity& solved);

/// What a patch of the floor sees through a hemicube, unfolded: each pixel in its patch's radiance.
Image hemicube_picture(const SceneRadiosity& solved);

/// The size of two pictures that stand side by side.
ImageSize half_wide(const ChapterRun& run);

}  // namespace raylab::cornell
