#pragma once

#include "raylab/sampling/pixel_filter.h"
#include "raylab/sampling/sampler.h"
#include "raylab/scene/camera.h"
#include "raylab/transport/path/purposes.h"
#include "raylab/transport/path/transport_model.h"

namespace raylab {

/// An eye ray of a pixel, and its weight in the pixel's mean.
struct EyeSample {
    Ray ray;
    double weight;  // of filters that are negative somewhere; 1 of all others
};

/// The ray through a point of the lens that the sampler chooses: all rays of a point of the picture meet in the plane
/// of the focus. `pinhole` is the ray through the lens' centre.
Ray lens_ray(const CameraFrame& frame, const Lens& lens, const RayOf<double>& pinhole, const Sampler& sampler,
             const SamplePlace& place);

/// A scene's camera, without a shutter that makes no difference because nothing moves: then no time is chosen.
Camera needed_camera(const Scene& scene);

/// A time while the shutter is open, in seconds.
float shutter_time(const Shutter& shutter, const Sampler& sampler, const SamplePlace& place);

/// The eye ray of a sample: through a point around the pixel's centre, chosen as the filter has it; from a point of the
/// lens, if there is one; at a time while the shutter is open, if it is. What a camera does not have uses no random
/// number.
template <class Model = TransportModel>
EyeSample eye_sample(const CameraFrame& frame, const Camera& camera, const PixelFilter& filter, const Sampler& sampler,
                     const SamplePlace& place) {
    const FilterSample at = filter_sample(filter, pair(sampler, place, purpose::picture));
    const auto pinhole = picture_ray(frame, place.x + 0.5 + at.x, place.y + 0.5 + at.y);
    EyeSample sample{{convert<float>(pinhole.origin), convert<float>(pinhole.direction)}, at.weight};
    if (Model::lens && camera.lens && camera.lens->radius > 0) [[unlikely]]
        sample.ray = lens_ray(frame, *camera.lens, pinhole, sampler, place);
    if (Model::time && camera.shutter) [[unlikely]]
        sample.ray.time = shutter_time(*camera.shutter, sampler, place);
    return sample;
}

}  // namespace raylab
