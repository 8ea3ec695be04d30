#include "raylab/radiosity/final_gather.h"

#include "raylab/radiosity/form_factor/contour_form_factor.h"
#include "raylab/radiosity/scene_system.h"
#include "raylab/sampling/random.h"
#include "raylab/scene/background.h"

#include <algorithm>
#include <numbers>

namespace raylab {

namespace {

Vec3d end_of_ray(const Patch& on, std::uint32_t number, const GatherRays& rays) {
    if (rays.end == GatherRays::End::centre) return on.center;
    const auto random = [&](std::uint64_t dimension) {
        return random_number({.seed = 2, .pixel = number, .sample = rays.sample, .dimension = dimension});
    };
    return point_of(on, random(0), random(1));
}

}  // namespace

FinalGather::Found FinalGather::at(std::uint32_t patch, const Vec3d& point, const GatherRays& rays,
                                   Traversal& traversal) const {
    const Patch& here = view_.mesh.patches[patch];
    Color arriving = lights_.at({patch, here}, point, traversal);
    double filled = 0;
    for (std::uint32_t i = 0; i < view_.mesh.patches.size(); ++i) {
        const Patch& other = view_.mesh.patches[i];
        if (!(dot(point - other.center, other.normal) > 0)) continue;
        const double factor = contour_form_factor(point, here.normal, other.polygon());
        if (!(factor > 0) || !view_.visibility.sees(patch, point, i, end_of_ray(other, i, rays), traversal)) continue;
        arriving += factor * view_.patches[i];
        filled += factor;
    }
    if (sends_light(view_.mesh.model.scene.background)) {
        constexpr int rays_outside = 64;
        arriving += background_light(view_.visibility.surroundings(patch, point, rays_outside, traversal), filled);
    }
    const Material& material = view_.mesh.material(here);
    return {std::numbers::pi * material.emission + patch_reflectance(view_.mesh, here) * arriving, filled};
}

}  // namespace raylab
