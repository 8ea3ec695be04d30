#include "raylab/scene/parts_of_light.h"

namespace raylab {

Scene without_lights(const Scene& scene) {
    Scene part = scene;
    part.lights.clear();
    return part;
}

Scene by_light_alone(const Scene& scene, std::size_t light) {
    Scene part = scene;
    part.lights = {scene.lights.at(light)};
    part.background = {};
    for (Material& material : part.materials) material.emission = {0, 0, 0};
    return part;
}

}  // namespace raylab
