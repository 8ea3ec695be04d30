#include "light_paths.h"

#include "light_source.h"

#include "raylab/base/error.h"
#include "raylab/tracer/picture/eye_picture.h"
#include "raylab/tracer/shading/surface_point.h"

#include <atomic>
#include <limits>
#include <numbers>
#include <utility>

namespace raylab::ray_generation {

ShadingLight light_of(const Scene& scene) {
    if (scene.lights.size() == 1)
        if (const auto* point = std::get_if<PointLight>(&scene.lights[0].kind))
            return {point->position, scene.lights[0].color};
    throw Error({scene.source}, "exactly one light, a point",
                std::to_string(scene.lights.size()) + " lights, or another kind");
}

Ray ray_from(const Vec3d& origin, const Vec3d& direction, float start) {
    return {.origin = convert<float>(origin),
            .direction = convert<float>(direction),
            .range = {start, std::numeric_limits<float>::infinity()}};
}

namespace {

// The radiance towards the ray's origin of a surface under the point light: diffuse / pi times intensity cos /
// distance^2.
Color lit_surface(const Scene& scene, const ShadingLight& light, const SurfacePoint& point, const Vec3d& direction) {
    const Vec3d to_light = light.position - point.position;
    const double squared = dot(to_light, to_light);
    const double cos_light = dot(facing(point.normal, direction), to_light) / std::sqrt(squared);
    if (!(cos_light > 0)) return {0, 0, 0};
    return diffuse_color(scene, point, direction) / std::numbers::pi * light.intensity * (cos_light / squared);
}

Ray shadow_ray_to(const ShadingLight& light, const Vec3d& position) {
    const double distance = glm::length(light.position - position);
    Ray shadow_ray = ray_from(position, (light.position - position) / distance, skin);
    shadow_ray.range.max = cast<float>(distance);
    return shadow_ray;
}

}  // namespace

BackwardResult trace_backward(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                              int samples_per_side, int threads) {
    const ShadingLight light = light_of(scene);
    std::atomic<std::uint64_t> segments = 0;
    const auto color = [&](const Ray& ray) -> Color {
        Traversal traversal;
        ++segments;
        const auto hit = accelerator.closest(ray, traversal);
        if (!hit) return {0, 0, 0};
        const SurfacePoint point = surface_point(scene, ray, *hit);
        const Color lit = lit_surface(scene, light, point, convert<double>(ray.direction));
        if (lit == Color{0, 0, 0}) return lit;
        ++segments;
        return accelerator.occluded(shadow_ray_to(light, point.position), traversal) ? Color{0, 0, 0} : lit;
    };
    const PixelSamples samples{.pattern = SamplePattern::jittered, .per_side = samples_per_side};
    Image picture = eye_picture(frame, {.samples = samples, .threads = threads}, color);
    return {std::move(picture), segments};
}

}  // namespace raylab::ray_generation
