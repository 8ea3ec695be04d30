#include "raylab/tracer/lone_sphere.h"

#include "raylab/geometry/intersect.h"

namespace raylab {

namespace {

Sphere sphere_of(const Object& object) { return std::get<Sphere>(object.shape); }

// Of larger coordinates is_outside() does not know what becomes when they are rounded.
constexpr double largest_in_radii = 0x1p22;

}  // namespace

bool LoneSphere::suits(const Scene& scene) {
    if (scene.objects.size() != 1 || scene.objects[0].sides != Sides::both) return false;
    const Sphere sphere = sphere_of(scene.objects[0]);
    return largest_coordinate(convert<double>(sphere.center)) <= largest_in_radii * sphere.radius;
}

LoneSphere::Settled LoneSphere::settle(RayOf<double> ray) const {
    const Ray floats{convert<float>(ray.origin), convert<float>(ray.direction), {cast<float>(ray.range.min), cast<float>(ray.range.max)}};
    Decisions decisions;
    const auto hit = intersect(floats, sphere_of(*sphere_.object), decisions);
    if (!hit) return {std::nullopt, decisions.exact};
    const Vec3d near = ray.origin + hit->t * ray.direction;
    const bool inward = !(dot(sphere_.point(near).normal, glm::normalize(ray.direction)) > 0);
    return {Met{hit->t, near, inward ? sphere_filter::Way::in : sphere_filter::Way::out}, decisions.exact};
}

}  // namespace raylab
