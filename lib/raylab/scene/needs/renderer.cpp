#include "raylab/scene/renderer.h"

#include <algorithm>

namespace raylab {

namespace {

// Glass never ends a ray, at whatever depth, because surfaces inside a medium of higher priority are passed without
// being counted.
bool ends_rays(const Material& material, int depth) { return material.kt == 0 && (material.kr == 0 || depth == 1); }

// Only materials that some object has are asked, because a file may define more.
bool all_materials(const Scene& scene, const auto& property) {
    return std::ranges::all_of(scene.objects, [&](const Object& object) {
        return property(scene.materials[object.front]) && property(scene.materials[object.back]);
    });
}

}  // namespace

Renderer cheapest_renderer(const Scene& scene, const PictureAsks& picture) {
    const auto ends = [&](const Material& material) { return ends_rays(material, picture.depth); };
    if (!all_materials(scene, ends)) return Renderer::whitted;
    return picture.shadow_rays ? Renderer::direct_light : Renderer::local_light;
}

std::string name_of(Renderer renderer) {
    switch (renderer) {
        case Renderer::local_light:
            return "local_light";
        case Renderer::direct_light:
            return "direct_light";
        case Renderer::whitted:
            break;
    }
    return "whitted";
}

std::string in_words(Renderer renderer) {
    switch (renderer) {
        case Renderer::local_light:
            return "eye rays end where they hit a surface, and no shadow ray is cast";
        case Renderer::direct_light:
            return "eye rays end where they hit a surface, and shadow rays are cast from "
                   "there";
        case Renderer::whitted:
            break;
    }
    return "rays go on from surfaces";
}

}  // namespace raylab
