#include "raylab/scene/renderer.h"

#include <algorithm>

namespace raylab {

namespace {

// Glass at whatever depth: surfaces within matter of higher priority are passed without being counted.
bool ends_rays(const Material& material, int depth) { return material.kt == 0 && (material.kr == 0 || depth == 1); }

bool is_sphere_at_rest(const Object& object) {
    return std::holds_alternative<Sphere>(object.shape) && object.placement.is_identity();
}

}  // namespace

Renderer least_renderer(const Scene& scene, const RaysAsked& rays, FoundBy found_by) {
    const auto ends = [&](const Material& material) { return ends_rays(material, rays.depth); };
    if (rays.feelers || !std::ranges::all_of(scene.materials, ends)) return Renderer::whitted;
    const bool spheres = !scene.objects.empty() && std::ranges::all_of(scene.objects, is_sphere_at_rest);
    return spheres && found_by == FoundBy::list ? Renderer::local_light_on_spheres : Renderer::local_light;
}

std::string name_of(Renderer renderer) {
    switch (renderer) {
        case Renderer::local_light_on_spheres: return "local_light_on_spheres";
        case Renderer::local_light: return "local_light";
        case Renderer::whitted: break;
    }
    return "whitted";
}

std::string in_words(Renderer renderer) {
    const std::string local = "rays end where they meet a surface, and none is felt for a light";
    switch (renderer) {
        case Renderer::local_light_on_spheres: return local + "; nothing but listed spheres is met";
        case Renderer::local_light: return local;
        case Renderer::whitted: break;
    }
    return "rays go on from surfaces, or are felt for lights";
}

}  // namespace raylab
