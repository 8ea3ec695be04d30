#include "shadow_rays.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/geometry/nearest_sphere_hit.h"
#include "raylab/geometry/quadric.h"
#include "raylab/geometry/triangle_hit.h"
#include "raylab/tracer/in_shadow.h"

#include <cmath>
#include <limits>
#include <memory>

namespace raylab::shadows {

namespace {

using Point = RayStart::Point;
using Offset = RayStart::Offset;
using Leaving = RayStart::Leaving;

Illumination light_from(const Vec3d& point, const Vec3d& light) {
    const double distance = glm::length(light - point);
    return {(light - point) / distance, distance, {1, 1, 1}};
}

Shade shade_by_shadow_ray(const Scene& scene, const Accelerator& accelerator, const RayStart& start,
                          const ShadowQuestion& question) {
    Traversal traversal;
    return accelerator.occluded(shadow_ray_from(scene, start, question), traversal) ? Shade::blocked : Shade::lit;
}

ShadowMethod by_shadow_ray(const NamedStart& named) {
    return {named.name, "float", "",
            [](std::span<const Scene> scenes) {
                return std::any(std::shared_ptr<const Accelerator>(make_accelerator("auto", scenes.front())));
            },
            [start = named.start](const std::any& state, std::span<const Scene> scenes,
                                  std::span<const ShadowQuestion> questions, std::span<Shade> answers) {
                const auto& accelerator = *std::any_cast<const std::shared_ptr<const Accelerator>&>(state);
                for (std::size_t i = 0; i < questions.size(); ++i)
                    answers[i] = shade_by_shadow_ray(scenes.front(), accelerator, start, questions[i]);
            }};
}

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The scene as in a textbook: spheres and triangles in doubles, each tested in turn.
struct InDoubles {
    std::vector<SphereOf<double>> spheres;
    std::vector<TriangleOf<double>> triangles;

    explicit InDoubles(const Scene& scene) {
        for (const Object& object : scene.objects) {
            if (const auto* sphere = std::get_if<Sphere>(&object.shape)) spheres.push_back(in<double>(*sphere));
            if (const auto* triangle = std::get_if<Triangle>(&object.shape)) triangles.push_back(in<double>(*triangle));
        }
    }

    std::optional<double> first_hit(const Vec3d& origin, const Vec3d& direction) const {
        RayOf<double> ray{origin, direction, {0, infinity}};
        std::optional<double> nearest;
        const auto offer = [&](double t) {
            nearest = t;
            ray.range.max = t;
        };
        for (const auto& sphere : spheres)
            if (const auto t = nearest_sphere_hit(ray, sphere)) offer(*t);
        for (const auto& triangle : triangles)
            if (const auto hit = triangle_hit(ray, triangle)) offer(hit->t);
        return nearest;
    }
};

// O + t d with t in double precision, because a Hit's t is only accurate enough for floats.
Vec3d point_in_doubles(const Scene& scene, const ShadowQuestion& question) {
    const RayOf<double> ray = in<double>(question.arrived);
    const Shape& shape = scene.objects[question.hit.primitive.object].shape;
    double t = question.hit.t;
    if (const auto* sphere = std::get_if<Sphere>(&shape)) t = nearest_sphere_hit(ray, in<double>(*sphere)).value_or(t);
    if (const auto* triangle = std::get_if<Triangle>(&shape))
        if (const auto hit = triangle_hit(ray, in<double>(*triangle))) t = hit->t;
    return ray.origin + ray.direction * t;
}

ShadowMethod by_function(const std::string& name) {
    return {name, "double", "", [](std::span<const Scene> scenes) { return std::any(InDoubles(scenes.front())); },
            [](const std::any& state, std::span<const Scene> scenes, std::span<const ShadowQuestion> questions,
               std::span<Shade> answers) {
                const auto& list = std::any_cast<const InDoubles&>(state);
                const FirstHit first_hit = [&](const Vec3d& o, const Vec3d& d) { return list.first_hit(o, d); };
                for (std::size_t i = 0; i < questions.size(); ++i) {
                    const auto& [ray, hit, light] = questions[i];
                    const Vec3d normal =
                        facing(surface_point(scenes.front(), ray, hit).normal, convert<double>(ray.direction));
                    const Vec3d point = point_in_doubles(scenes.front(), questions[i]);
                    answers[i] = in_shadow(point, normal, light, first_hit) ? Shade::blocked : Shade::lit;
                }
            }};
}

}  // namespace

std::vector<NamedStart> starts() {
    return {{"none, O + t d", {Point::along_ray, Offset::none, 0, Leaving::forgotten}},
            {"none, on the surface", {Point::on_surface, Offset::none, 0, Leaving::forgotten}},
            {"none + skip", {Point::on_surface, Offset::none, 0, Leaving::known}},
            {"fixed 1e-4, O + t d", {Point::along_ray, Offset::fixed, 1e-4, Leaving::forgotten}},
            {"fixed 1e-4", {Point::on_surface, Offset::fixed, 1e-4, Leaving::forgotten}},
            {"fixed 1e-3", {Point::on_surface, Offset::fixed, 1e-3, Leaving::forgotten}},
            {"scaled 1e-5", {Point::on_surface, Offset::scaled, 1e-5, Leaving::forgotten}},
            {"error-bounded", {Point::on_surface, Offset::error_bounded, 0, Leaving::forgotten}},
            {"error-bounded + skip", {}}};
}

Ray shadow_ray_from(const Scene& scene, const RayStart& start, const ShadowQuestion& question) {
    const SurfacePoint at = surface_point(scene, question.arrived, question.hit);
    return shadow_ray(at, light_from(at.position, question.light), start, question.arrived, question.hit.t);
}

std::vector<ShadowMethod> shadow_methods(const ChapterRun& run) {
    std::vector<ShadowMethod> methods;
    for (const NamedStart& named : starts()) methods.push_back(by_shadow_ray(named));
    methods.push_back(by_function(run.name_of("in_shadow", "along the normal")));
    return methods;
}

}  // namespace raylab::shadows
