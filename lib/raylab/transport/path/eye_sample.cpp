#include "raylab/transport/path/eye_sample.h"

#include "raylab/sampling/mapping/lens_point.h"
#include "raylab/scene/moving.h"

#include <algorithm>

namespace raylab {

Ray lens_ray(const CameraFrame& frame, const Lens& lens, const RayOf<double>& pinhole, const Sampler& sampler,
             const SamplePlace& place) {
    const auto [u, v] = pair(sampler, place, purpose::lens);
    const DiskPoint on_lens = lens_point(lens.radius, u, v);
    const Vec3d sharp =
        pinhole.direction * (lens.focus / dot(pinhole.direction, frame.forward));  // from the lens' centre
    const Vec3d aside = on_lens.x * frame.right + on_lens.y * frame.up;
    return {convert<float>(pinhole.origin + aside), convert<float>(glm::normalize(sharp - aside))};
}

Camera needed_camera(const Scene& scene) {
    Camera camera = scene.camera;
    if (!anything_moves(scene)) camera.shutter.reset();
    return camera;
}

float shutter_time(const Shutter& shutter, const Sampler& sampler, const SamplePlace& place) {
    const auto [open, close] = shutter;
    const double moment = open == close ? 0 : number(sampler, place, purpose::time);
    const float time = cast<float>(open + (close - open) * moment);  // rounded, perhaps to beyond the closing
    return std::clamp(time, cast<float>(open), cast<float>(close));
}

}  // namespace raylab
