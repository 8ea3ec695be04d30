#include "raylab/tracer/shading/lighting.h"

raylab::Lighting::Lighting(const Scene& scene) : lights(scene.lights.begin(), scene.lights.end()) {
    finishes.reserve(scene.materials.size());
    for (const Material& material : scene.materials)
        finishes.push_back({material, material.emission + material.ambient * scene.background.ambient});
}
