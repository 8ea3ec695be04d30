#pragma once

#include "raylab/tracer/eye_picture.h"
#include "raylab/tracer/whitted.h"

namespace raylab {

/// A picture by Whitted's recursion, and what it took.
struct WhittedPicture {
    Image image;
    RayCounts rays;       // the same for every accelerator and any number of threads
    Traversal traversal;  // tests, over all rays
    double seconds = 0;   // of tracing
};

/// Whether no ray goes on from a surface, and none is felt for a light.
bool needs_local_light_only(const Scene& scene, const WhittedOptions& options);

/// The scene as this camera sees it.
Image whitted_picture(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                      const WhittedOptions& options = {}, const EyePictureOptions& picture = {});

/// The same bits, and the rays counted.
WhittedPicture counted_whitted_picture(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                                       const WhittedOptions& options = {}, const EyePictureOptions& picture = {});

}  // namespace raylab
