#include "raylab/tracer/listed_spheres.h"

#include "raylab/geometry/quadric.h"

namespace raylab {

ListedSpheres::ListedSpheres(const Scene& scene, const Accelerator&) : count_(scene.objects.size()) {
    spheres_.reserve(scene.objects.size());
    for (const Object& object : scene.objects) {
        const auto& sphere = std::get<Sphere>(object.shape);
        const auto whole = in<double>(sphere);
        const auto number = static_cast<std::uint32_t>(spheres_.size());
        spheres_.push_back({sphere, object.sides, whole, detail::rounding_error(detail::size_of(whole)), &object, {number, 0}});
    }
    others_ = std::span(spheres_).subspan(1);
}

bool ListedSpheres::is_before(const Ray& ray, const Listed& a, const Candidate& at_a, const Listed& b, const Candidate& at_b,
                              Decisions& decisions) {
    const auto target = [](const Listed& listed) -> Target {
        return {&listed.object->shape, 0, &listed.object->placement, listed.sides};
    };
    return order(ray, target(a), at_a, target(b), at_b, decisions) == Sign::negative;
}

}  // namespace raylab
