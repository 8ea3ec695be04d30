#include "raylab/scene/renderer.h"

#include <algorithm>

namespace raylab {

namespace {

// Glass at whatever depth: surfaces within matter of higher priority are passed without being counted.
bool ends_rays(const Material& material, int depth) { return material.kt == 0 && (material.kr == 0 || depth == 1); }

bool is_sphere_at_rest(const Object& object) {
    return std::holds_alternative<Sphere>(object.shape) && object.placement.is_identity();
}

bool is_plain_lamp(const Light& light) {
    return std::holds_alternative<PointLight>(light.kind) && light.attenuation == Vec3d{1, 0, 0};
}

bool is_plain(const Material& material) { return std::holds_alternative<Color>(material.diffuse); }

// Of the materials that something is made of: a file may have more.
bool all_materials(const Scene& scene, const auto& property) {
    return std::ranges::all_of(scene.objects, [&](const Object& object) {
        return property(scene.materials[object.front]) && property(scene.materials[object.back]);
    });
}

bool has_plain_spheres_only(const Scene& scene) {
    return !scene.objects.empty() && std::ranges::all_of(scene.objects, is_sphere_at_rest) &&
           std::ranges::all_of(scene.lights, is_plain_lamp) && all_materials(scene, is_plain);
}

}  // namespace

Renderer least_renderer(const Scene& scene, const PictureAsks& picture, FoundBy found_by) {
    const auto ends = [&](const Material& material) { return ends_rays(material, picture.depth); };
    if (picture.feelers || !all_materials(scene, ends)) return Renderer::whitted;
    const bool plain = found_by == FoundBy::list && picture.usual_look && has_plain_spheres_only(scene);
    return plain ? Renderer::plain_spheres : Renderer::local_light;
}

std::string name_of(Renderer renderer) {
    switch (renderer) {
        case Renderer::plain_spheres: return "plain_spheres";
        case Renderer::local_light: return "local_light";
        case Renderer::whitted: break;
    }
    return "whitted";
}

std::string in_words(Renderer renderer) {
    const std::string local = "rays end where they meet a surface, and none is felt for a light";
    switch (renderer) {
        case Renderer::plain_spheres: return local + "; there is nothing but a list of plain spheres in the light of points";
        case Renderer::local_light: return local;
        case Renderer::whitted: break;
    }
    return "rays go on from surfaces, or are felt for lights";
}

}  // namespace raylab
