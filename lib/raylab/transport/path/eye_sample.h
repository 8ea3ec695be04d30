#pragma once

#include "raylab/sampling/pixel_filter.h"
#include "raylab/sampling/sampler.h"
#include "raylab/scene/camera.h"

namespace raylab {

/// An eye ray of a pixel, and its weight in the pixel's mean.
struct EyeSample {
    Ray ray;
    double weight;  // of filters that are negative somewhere; 1 of all others
};

/// The eye ray of a sample: through a point around the pixel's centre, chosen as the filter has it; from a point of the
/// lens, if there is one; at a time while the shutter is open, if it is. What a camera does not have uses no random
/// number.
EyeSample eye_sample(const CameraFrame& frame, const Camera& camera, const PixelFilter& filter, const Sampler& sampler,
                     const SamplePlace& place);

}  // namespace raylab
