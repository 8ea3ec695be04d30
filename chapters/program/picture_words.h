#pragma once

#include "raylab/base/command_line.h"
#include "raylab/base/memory_limit.h"
#include "raylab/base/outputs.h"
#include "raylab/sampling/pixel_samples.h"
#include "raylab/scene/camera.h"
#include "raylab/tracer/picture_accelerator.h"
#include "raylab/tracer/whitted.h"

#include <vector>

// The options that `render` and `tree` share: which picture is drawn, and by what. So the tree of a pixel is made of the rays
// that drew it.

namespace raylab {

/// A picture as a command line asks for it, less what the scene does not need (tracer/only_needed.h).
struct AskedPicture {
    Scene scene;
    std::vector<std::size_t> lights;  // the numbers that its lights have in the scene's file: those that shine nowhere are gone
    WhittedOptions options;
    CameraFrame frame;
    PixelSamples samples;
    MemoryLimit limit;
};

CommandLine with_picture_options(CommandLine command_line);

/// Reads SCENE and the options. Error where an output would replace one of the scene's files.
AskedPicture asked_picture(const Arguments& arguments, Outputs& outputs);

/// What finds the picture's hits, as the options say.
PictureAccelerator picture_accelerator(const Arguments& arguments, const AskedPicture& picture);

}  // namespace raylab
