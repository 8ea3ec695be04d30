#include "raylab/scene/needs/parts.h"
#include "raylab/scene/pigment.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace raylab {

namespace {

bool answers_to_light(const Material& material) { return !is_black(material.diffuse) || material.specular != black; }

// The reason why the light can be left out; absent if it shines.
std::optional<std::string> why_not(const NeedsQuestion& question, const std::vector<bool>& seen, std::size_t number) {
    const Scene& scene = question.scene;
    const Light& light = scene.lights[number];
    if (scene.objects.empty()) return "there is nothing to light";
    if (light.color == black) return "it is black";
    bool answered = false;
    for (std::size_t i = 0; i < seen.size(); ++i)
        answered = answered || (seen[i] && answers_to_light(scene.materials[i]));
    if (!answered) return "no surface that is seen has a diffuse or a specular colour";
    for (const auto wall : question.walls[number])
        // No ray is transmitted, so nothing inside is ever seen.
        if (scene.materials[scene.objects[wall].front].kt == 0)
            return "it is shut in by " + name_of(scene, wall) + ", and the viewer is outside";
    return std::nullopt;
}

LightNeeds needs_of(const NeedsQuestion& question, const std::vector<bool>& seen, std::size_t number) {
    const Light& light = question.scene.lights[number];
    if (auto reason = why_not(question, seen, number)) return {.why = std::move(*reason)};
    const bool distant = std::holds_alternative<DistantLight>(light.kind);
    LightNeeds needs{.shines = true,
                     .shadow_rays = true,
                     .distance = !distant && (light.attenuation.y != 0 || light.attenuation.z != 0),
                     .cone = std::holds_alternative<SpotLight>(light.kind),
                     .why = "an object may stand between it and a point that it lights"};
    if (const auto* only = question.only_object()) {
        needs.why = name_of(question.scene, 0) + " may stand between it and another point of itself";
        if (auto reason = never_blocked(question.scene, *only, light)) {
            needs.shadow_rays = false;
            needs.why = std::move(*reason);
        }
    }
    return needs;
}

}  // namespace

std::vector<LightNeeds> light_needs(const NeedsQuestion& question, const std::vector<bool>& seen) {
    std::vector<LightNeeds> all;
    for (std::size_t i = 0; i < question.scene.lights.size(); ++i) all.push_back(needs_of(question, seen, i));
    return all;
}

std::vector<Note> warnings_of(const NeedsQuestion& question) {
    const Scene& scene = question.scene;
    std::vector<Note> warnings;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        auto around = question.walls[i];
        std::ranges::copy(meshes_around(scene, scene.lights[i]), std::back_inserter(around));
        for (const auto wall : around)
            warnings.push_back({fmt::format("light {} lies inside {}", i, name_of(scene, wall)),
                                "shadow rays stop at its surface: nothing outside is lit by it"});
    }
    return warnings;
}

std::string light_name(const Scene& scene, std::size_t light) {
    static constexpr std::array kinds{"point", "spot", "distant"};  // in the order of the variant
    return fmt::format("light {} ({})", light, kinds.at(scene.lights[light].kind.index()));
}

}  // namespace raylab
