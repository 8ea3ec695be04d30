#include "raylab/radiosity/scene_system.h"

#include "raylab/base/printable.h"
#include "raylab/scene/background.h"
#include "raylab/scene/pigment.h"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

namespace raylab {

namespace {

void check_color(const Scene& scene, const Material& material, const Color& color) {
    for (int channel = 0; channel < 3; ++channel)
        if (!(color[channel] >= 0 && color[channel] < 1))
            throw Error({scene.source, 0, "material " + material.name},
                        "a diffuse colour of at least 0 and less than 1 in each channel",
                        fmt::format("{}", color[channel]));
}

bool has_light(const Scene& scene) {
    return !scene.lights.empty() || sends_light(scene.background) ||
           std::ranges::any_of(scene.materials, [](const Material& m) { return m.emission != Color(0); });
}

}  // namespace

Color patch_reflectance(const PatchMesh& mesh, const Patch& patch) {
    return color_at(mesh.material(patch).diffuse, patch.center, patch.normal);
}

std::vector<std::string> beyond_radiosity(const Scene& scene) {
    std::vector<std::string> words;
    for (const Material& material : scene.materials) {
        const std::string name = printable(material.name);
        if (material.kr > 0) words.push_back(fmt::format("the mirror of material {} (kr = {:.3g})", name, material.kr));
        if (material.kt > 0)
            words.push_back(fmt::format("the transparency of material {} (kt = {:.3g})", name, material.kt));
        if (material.specular != Color{0, 0, 0}) words.push_back(fmt::format("the highlight of material {}", name));
        if (material.ambient != Color{0, 0, 0} && scene.background.ambient != Color{0, 0, 0})
            words.push_back(
                fmt::format("the ambient term of material {}: the light between surfaces is computed instead", name));
    }
    return words;
}

std::optional<std::string> refused_by_radiosity(const Scene& scene) {
    if (std::ranges::any_of(scene.objects, [](const Object& o) { return std::holds_alternative<Plane>(o.shape); }))
        return "an infinite plane, which cannot be cut into patches";
    if (!has_light(scene)) return "nothing that emits light";
    try {
        check_reflectances(scene);
    } catch (const Error& error) {
        return error.what();
    }
    return std::nullopt;
}

void check_reflectances(const Scene& scene) {
    for (const Material& material : scene.materials)
        if (const auto* plain = std::get_if<Color>(&material.diffuse)) {
            check_color(scene, material, *plain);
        } else {
            const auto& checker = std::get<Checker>(material.diffuse);
            check_color(scene, material, checker.a);
            check_color(scene, material, checker.b);
        }
}

Error no_light(const Scene& scene) {
    return {{scene.source}, "a light, a material with emission or a background that is not black", "none"};
}

}  // namespace raylab
