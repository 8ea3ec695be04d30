#include "light_paths.h"

#include "lamp.h"

#include "raylab/base/error.h"
#include "raylab/tracer/eye_picture.h"
#include "raylab/tracer/surface_point.h"

#include <atomic>
#include <limits>
#include <numbers>
#include <utility>

namespace raylab::ray_generation {

Lamp lamp_of(const Scene& scene) {
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
Color lit_surface(const Scene& scene, const Lamp& lamp, const SurfacePoint& point, const Vec3d& direction) {
    const Vec3d to_lamp = lamp.position - point.position;
    const double squared = dot(to_lamp, to_lamp);
    const double cos_lamp = dot(facing(point.normal, direction), to_lamp) / std::sqrt(squared);
    if (!(cos_lamp > 0)) return {0, 0, 0};
    return diffuse_color(scene, point, direction) / std::numbers::pi * lamp.intensity * (cos_lamp / squared);
}

Ray feeler_to(const Lamp& lamp, const Vec3d& position) {
    const double distance = glm::length(lamp.position - position);
    Ray feeler = ray_from(position, (lamp.position - position) / distance, skin);
    feeler.range.max = cast<float>(distance);
    return feeler;
}

}  // namespace

BackwardResult trace_backward(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                              int samples_per_side, int threads) {
    const Lamp lamp = lamp_of(scene);
    std::atomic<std::uint64_t> segments = 0;
    const auto color = [&](const Ray& ray) -> Color {
        Traversal traversal;
        ++segments;
        const auto hit = accelerator.closest(ray, traversal);
        if (!hit) return {0, 0, 0};
        const SurfacePoint point = surface_point(scene, ray, *hit);
        const Color lit = lit_surface(scene, lamp, point, convert<double>(ray.direction));
        if (lit == Color{0, 0, 0}) return lit;
        ++segments;
        return accelerator.occluded(feeler_to(lamp, point.position), traversal) ? Color{0, 0, 0} : lit;
    };
    const PixelSamples samples{.pattern = SamplePattern::jittered, .per_side = samples_per_side};
    Image picture = eye_picture(frame, {.samples = samples, .threads = threads}, color);
    return {std::move(picture), segments};
}

}  // namespace raylab::ray_generation
