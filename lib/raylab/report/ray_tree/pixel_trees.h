#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/scene/camera.h"
#include "raylab/tracer/whitted/whitted.h"

#include <string>

// The ray trees of a grid of a picture's pixels, for a page on which you pick a pixel and see its rays. The page is
// opened as a file, and may then read no data but a script.

namespace raylab {

/// The picture whose pixels are picked.
struct PickedPicture {
    const Scene& scene;
    const Accelerator& accelerator;
    ImageSize image;
    WhittedOptions options;
    std::string command;  // `raylab tree` with the options that cast the same rays; `--pixel X,Y` is added to it
};

/// A script that calls raylab_trees({...}): for the pixel in the middle of each of 32 x 24 cells of the picture, the
/// rays of `raylab tree`, their numbers rounded to six digits; and outlines of the scene from above and from the side.
/// What the keys mean is said in page/script/pixel_trees.js.
std::string pixel_trees_script(const PickedPicture& picture);

}  // namespace raylab
