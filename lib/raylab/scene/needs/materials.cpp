#include "raylab/scene/needs/parts.h"
#include "raylab/scene/pigment.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

std::vector<bool> seen_materials(const NeedsQuestion& question) {
    std::vector<bool> seen(question.scene.materials.size());
    for (std::size_t i = 0; i < question.objects.size(); ++i) {
        const Object& object = question.scene.objects[i];
        if (question.objects[i].front_seen) seen[object.front] = true;
        if (question.objects[i].back_seen) seen[object.back] = true;
    }
    return seen;
}

std::vector<MaterialNeeds> material_needs(const NeedsQuestion& question, const std::vector<bool>& seen,
                                          const std::vector<LightNeeds>& lights, const Recursion& recursion) {
    const bool lit = std::ranges::any_of(lights, &LightNeeds::shines);
    std::vector<MaterialNeeds> all;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const Material& m = question.scene.materials[i];
        MaterialNeeds needs{.seen = seen[i]};
        if (seen[i]) {
            needs.ambient = m.ambient * question.scene.background.ambient != black;
            needs.diffuse = lit && !is_black(m.diffuse);
            needs.highlight = lit && m.specular != black;
            needs.emission = m.emission != black;
            needs.checker = needs.diffuse && depends_on_point(m.diffuse);
            const auto largest = passed_on(question, m);
            needs.reflection = recursion.depth > 1 && question.worth_a_ray(largest.reflected);
            needs.transmission = recursion.depth > 1 && question.worth_a_ray(largest.transmitted);
            needs.refraction = needs.transmission && question.bends_light;
        }
        all.push_back(needs);
    }
    return all;
}

std::string material_name(const Scene& scene, std::size_t material) {
    const auto& name = scene.materials[material].name;
    return name.empty() ? fmt::format("material {}", material) : name;
}

std::vector<std::string> materials_with(const Scene& scene, const std::vector<MaterialNeeds>& materials,
                                        bool MaterialNeeds::*property) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < materials.size(); ++i)
        if (materials[i].*property) names.push_back(material_name(scene, i));
    return names;
}

}  // namespace raylab
