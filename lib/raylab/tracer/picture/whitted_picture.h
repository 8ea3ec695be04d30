#pragma once

#include "raylab/scene/renderer.h"
#include "raylab/tracer/picture/eye_picture.h"
#include "raylab/tracer/whitted/whitted.h"

namespace raylab {

/// A picture by Whitted's recursion, and what it took.
struct WhittedPicture {
    Image image;
    RayCounts rays;       // the same for every accelerator and any number of threads
    Traversal traversal;  // tests, over all rays
    double seconds = 0;   // of tracing
};

/// The renderer that draws the picture: the least of them that can. All make the same bits and counts.
Renderer cheapest_renderer(const Scene& scene, const WhittedOptions& options);

/// The scene as this camera sees it.
Image whitted_picture(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                      const WhittedOptions& options = {}, const EyePictureOptions& picture = {});

/// The same bits, and the rays counted.
WhittedPicture counted_whitted_picture(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                                       const WhittedOptions& options = {}, const EyePictureOptions& picture = {});

/// One of the samples of a pixel.
struct PixelSample {
    int x, y;
    int number = 0;  // from 0 to PixelSamples::count() - 1
};

/// The tree of all rays of one sample, by the code that draws the picture: the mean of the samples' RayTree::pixel,
/// added in their order and rounded to floats, is the picture's pixel to the bit.
RayTree sample_tree(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                    const WhittedOptions& options, const PixelSamples& samples, const PixelSample& sample);

}  // namespace raylab
