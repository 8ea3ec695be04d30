#pragma once

#include "raylab/base/command_line.h"
#include "raylab/base/memory_limit.h"
#include "raylab/base/outputs.h"
#include "raylab/sampling/pixel_samples.h"
#include "raylab/scene/camera.h"
#include "raylab/tracer/picture/picture_accelerator.h"
#include "raylab/tracer/whitted/whitted.h"

#include <string>
#include <vector>

// The options that `render` and `tree` share: which picture is drawn, and how. So the ray tree of a pixel consists of
// the rays that drew it.

namespace raylab {

/// A picture as the command line asks for it, without what the scene does not need (tracer/picture/only_needed.h).
struct AskedPicture {
    Scene scene;
    // The numbers of its lights in the scene's file, from which those without effect are removed.
    std::vector<std::size_t> lights;
    WhittedOptions options;
    CameraFrame frame;
    PixelSamples samples;
    MemoryLimit limit;
};

/// Reads --size: "640x480". It throws an Error for anything else.
ImageSize size_from_words(const std::string& words);

CommandLine with_picture_options(CommandLine command_line);

/// A scene as the command line asks for it, with the model that draws it: never `automatic`.
struct AskedScene {
    Scene scene;
    MemoryLimit limit;
};

/// Reads SCENE. It throws an Error where an output would replace one of the scene's files.
AskedScene asked_scene(const Arguments& arguments, Outputs& outputs);

/// The --samples of a picture: rays for each pixel.
int asked_samples(const Arguments& arguments, int otherwise);

/// Throws an Error where an option of Whitted's model is given: rays that are spread do not know it.
void refuse_whitted_words(const Arguments& arguments);

/// The options of a picture by Whitted's model.
AskedPicture asked_picture(const Arguments& arguments, AskedScene asked);

/// Where the recursion ends, in words.
std::string recursion_words(const AskedPicture& picture);

/// What is said of the structure that was chosen: that many rays pay for it, where few would not; empty: nothing.
std::string choice_words(const Arguments& arguments, const Scene& scene, const std::string& chosen);

/// The accelerator that the options choose for the picture.
PictureAccelerator picture_accelerator(const Arguments& arguments, const AskedPicture& picture, int build_threads);

}  // namespace raylab
