#include "raylab/tracer/local_color.h"

#include "raylab/tracer/shading/reflected_light.h"

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    const auto& [normal, to_viewer, unlit, diffuse, specular, shininess] = surface;
    const Material material{.specular = specular, .shininess = shininess};
    Vec3d sum = unlit;
    for (const auto& [way, color, attenuation] : lights) {
        const double distance = glm::length(way);
        const double falls = attenuation.x + distance * (attenuation.y + distance * attenuation.z);
        const Illumination light{way / distance, distance, color / falls};
        sum += reflected_light(light, {{0, 0, 0}, normal, to_viewer}, diffuse, material);
    }
    return sum;
}
