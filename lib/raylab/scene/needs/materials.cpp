#include "raylab/scene/needs/parts.h"
#include "raylab/scene/pigment.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

namespace {

constexpr Color black{0, 0, 0};

// Light falling out of a denser medium at a shallow angle is reflected whole: the mirrored ray then carries kt too.
bool may_reflect_totally(const Material& material) { return material.kt > 0 && material.ior != 1; }

double largest_reflected(const Material& material) {
    return material.kr + (may_reflect_totally(material) ? material.kt : 0);
}

// The smallest depth d with k^d < threshold: a ray at depth d was passed on d - 1 times, so deeper ones weigh less than
// the threshold. (Multiplied step by step, as a renderer does it: rounding is monotonic, so no product of smaller
// coefficients comes out larger.)
Recursion counted(double coefficient, const NeedsOptions& options) {
    Recursion found{{.coefficient = coefficient}, 1};
    double share = coefficient;
    for (; worth_a_ray(share, options.threshold) && found.depth < options.depth_limit; share *= coefficient)
        ++found.depth;
    found.passed_on.stopped_by_limit = worth_a_ray(share, options.threshold);
    found.passed_on.why = fmt::format("k = {:.4g} is the most that a surface passes on; ", coefficient) +
                          (found.passed_on.stopped_by_limit
                               ? fmt::format("k^{} is not yet under {:.3g}, so the limit of depth ends it", found.depth,
                                             options.threshold)
                               : fmt::format("k^{} is the first under {:.3g}", found.depth, options.threshold));
    return found;
}

}  // namespace

std::vector<bool> seen_materials(const NeedsQuestion& question) {
    std::vector<bool> seen(question.scene.materials.size());
    for (std::size_t i = 0; i < question.objects.size(); ++i) {
        const Object& object = question.scene.objects[i];
        if (question.objects[i].front_seen) seen[object.front] = true;
        if (question.objects[i].back_seen) seen[object.back] = true;
    }
    return seen;
}

Recursion recursion_needs(const NeedsQuestion& question, const std::vector<bool>& seen) {
    const Scene& scene = question.scene;
    double coefficient = 0;
    bool reflection = false, transmission = false;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (!seen[i]) continue;
        const Material& material = scene.materials[i];
        coefficient = std::max({coefficient, largest_reflected(material), material.kt});
        reflection = reflection || question.worth_a_ray(largest_reflected(material));
        transmission = transmission || question.worth_a_ray(material.kt);
    }
    if (!reflection && !transmission) {
        const auto why = coefficient > 0
                             ? fmt::format("kr and kt of all that is seen are under {:.3g}", question.options.threshold)
                             : "nothing that is seen is a mirror or a glass";
        return {{.coefficient = coefficient, .why = why}, 1};
    }
    Recursion found = counted(coefficient, question.options);
    if (question.shows_only_background()) {
        const bool dark = scene.background.color == black;
        found.depth = std::min(found.depth, dark ? 1 : 2);
        found.passed_on.stopped_by_limit = false;
        found.passed_on.why = name_of(scene, 0) + " is alone: a ray that leaves it meets only the " +
                              (dark ? "black background" : "background");
    }
    found.passed_on.reflection = reflection && found.depth > 1;
    found.passed_on.transmission = transmission && found.depth > 1;
    return found;
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
            needs.reflection = recursion.depth > 1 && question.worth_a_ray(largest_reflected(m));
            needs.transmission = recursion.depth > 1 && question.worth_a_ray(m.kt);
            needs.refraction = needs.transmission && m.ior != 1;
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
