#include "raylab/tracer/picture/first_hit_picture.h"

#include "raylab/scene/background.h"
#include "raylab/tracer/shading/surface_point.h"

#include <algorithm>

namespace raylab {

Vec3d shoulder_light(const CameraFrame& frame) { return 0.8 * frame.up - 0.5 * frame.right - frame.forward; }

Color first_hit_color(const Scene& scene, const Accelerator& accelerator, const Ray& ray, FirstHitShading look,
                      const Vec3d& to_light) {
    Traversal traversal;
    const auto hit = accelerator.closest(ray, traversal);
    if (!hit) return background_color(scene.background, ray.direction);
    const SurfacePoint point = surface_point(scene, ray, *hit);
    const Vec3d direction = convert<double>(ray.direction), normal = facing(point.normal, direction);
    if (look == FirstHitShading::normals) return 0.5 * (normal + Vec3d{1, 1, 1});
    constexpr double shade = 0.15;  // what the light does not reach is not black
    const double lit = std::max(0.0, dot(normal, glm::normalize(to_light)));
    return (shade + (1 - shade) * lit) * diffuse_color(scene, point, direction);
}

Image first_hit_picture(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                        FirstHitShading look, const EyePictureOptions& options) {
    const Vec3d light = shoulder_light(frame);
    return eye_picture(frame, options,
                       [&](const Ray& ray) { return first_hit_color(scene, accelerator, ray, look, light); });
}

}  // namespace raylab
