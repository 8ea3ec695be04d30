#include "raylab/transport/path/eye_sample.h"

#include "raylab/sampling/mapping/lens_point.h"
#include "raylab/transport/path/purposes.h"

#include <algorithm>

namespace raylab {

namespace {

// The ray through a thin lens: all rays of a point of the picture meet in the plane of the focus.
Ray through_lens(const CameraFrame& frame, const Lens& lens, const RayOf<double>& pinhole, const DiskPoint& on_lens) {
    const Vec3d sharp =
        pinhole.direction * (lens.focus / dot(pinhole.direction, frame.forward));  // from the lens' centre
    const Vec3d aside = on_lens.x * frame.right + on_lens.y * frame.up;
    return {convert<float>(pinhole.origin + aside), convert<float>(glm::normalize(sharp - aside))};
}

}  // namespace

EyeSample eye_sample(const CameraFrame& frame, const Camera& camera, const PixelFilter& filter, const Sampler& sampler,
                     const SamplePlace& place) {
    const FilterSample at = filter_sample(filter, pair(sampler, place, purpose::picture));
    const auto pinhole = picture_ray(frame, place.x + 0.5 + at.x, place.y + 0.5 + at.y);
    EyeSample sample{{convert<float>(pinhole.origin), convert<float>(pinhole.direction)}, at.weight};
    if (camera.lens && camera.lens->radius > 0) {
        const auto [u, v] = pair(sampler, place, purpose::lens);
        sample.ray = through_lens(frame, *camera.lens, pinhole, lens_point(camera.lens->radius, u, v));
    }
    if (camera.shutter) {
        const auto [open, close] = *camera.shutter;
        const double moment = open == close ? 0 : number(sampler, place, purpose::time);
        const float time = cast<float>(open + (close - open) * moment);  // rounded, perhaps to beyond the closing
        sample.ray.time = std::clamp(time, cast<float>(open), cast<float>(close));
    }
    return sample;
}

}  // namespace raylab
