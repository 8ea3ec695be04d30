#include "raylab/tracer/listed_spheres.h"

namespace raylab {

ListedSpheres::ListedSpheres(const Scene& scene, const Accelerator& list) : list_(list), count_(scene.objects.size()) {
    spheres_.reserve(scene.objects.size());
    for (const Object& object : scene.objects) {
        const auto& sphere = std::get<Sphere>(object.shape);
        const auto number = static_cast<std::uint32_t>(spheres_.size());
        spheres_.push_back({object.sides, sphere_filter::Ball(sphere), SpherePosition(sphere), &object, {number, 0}});
    }
    first_ = spheres_.data();
}

std::optional<ListedSpheres::Met> ListedSpheres::closest_of_several(const Ray& ray, Traversal& traversal) const {
    const auto hit = list_.closest(ray, traversal);
    if (!hit) return std::nullopt;
    return Met{hit->t, &spheres_[hit->primitive.object], convert<double>(ray.origin) + hit->t * convert<double>(ray.direction)};
}

}  // namespace raylab
