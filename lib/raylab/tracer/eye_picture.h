#pragma once

#include "raylab/image/image.h"
#include "raylab/sampling/pixel_samples.h"
#include "raylab/scene/camera.h"

#include <functional>
#include <string>

namespace raylab {

struct EyePictureOptions {
    PixelSamples samples = {};
    int threads = 0;         // 0: all cores; the picture is the same bits for any number
    std::string label = {};  // of the progress bar; empty: none
};

/// A picture made of eye rays: each pixel is the mean of what `color` says along the rays through its samples.
Image eye_picture(const CameraFrame& frame, const EyePictureOptions& options,
                  const std::function<Color(const Ray&)>& color);

/// A colour as pictures store it.
Pixel to_pixel(const Color& color);

}  // namespace raylab
