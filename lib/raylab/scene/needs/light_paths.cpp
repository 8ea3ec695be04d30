#include "raylab/scene/needs/parts.h"
#include "raylab/scene/pigment.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

namespace {

// The part of a path between a light and the first ray that is reflected or transmitted: the terms of the local model.
std::string local_term(const Needs& needs) {
    const bool diffuse = std::ranges::any_of(needs.materials, &MaterialNeeds::diffuse);
    const bool highlight = std::ranges::any_of(needs.materials, &MaterialNeeds::highlight);
    if (diffuse && highlight) return "(D|S)";
    return diffuse ? "D" : highlight ? "S" : "";
}

std::string local_sentence(const std::string& term) {
    if (term == "D") return "local: light falls on a diffuse surface, which scatters it to the eye";
    if (term == "S") return "local: a surface shows the eye the highlight of a light";
    return "local: light falls on a surface, which scatters it to the eye (D) or shows a highlight (S)";
}

std::string by_what(const Needs& needs) {
    if (!needs.passed_on.transmission) return "in mirrors";
    return needs.passed_on.reflection ? "in mirrors and through glass" : "through glass";
}

std::string times(int largest) { return largest == 1 ? "S" : fmt::format("S{{1,{}}}", largest); }

// The ways in which surfaces really scatter light, whatever the method models of it.
struct Scatterers {
    bool diffuse = false, specular = false;
    bool intersect = false;  // light from one of them can fall on another, or on itself
};

Scatterers scatterers(const NeedsQuestion& question) {
    Scatterers found;
    std::size_t count = 0;
    for (std::size_t i = 0; i < question.objects.size(); ++i) {
        const auto& [front_seen, back_seen, clear] = question.objects[i];
        const auto has = [&](const auto& property) {
            const Object& object = question.scene.objects[i];
            return (front_seen && property(question.scene.materials[object.front])) ||
                   (back_seen && property(question.scene.materials[object.back]));
        };
        const bool diffuse = has([](const Material& m) { return !is_black(m.diffuse); });
        const bool specular = has([](const Material& m) { return m.kr > 0 || m.kt > 0; });
        found.diffuse = found.diffuse || diffuse;
        found.specular = found.specular || specular;
        if (!diffuse && !specular) continue;
        ++count;
        found.intersect = found.intersect || count > 1 || !clear;
    }
    return found;
}

std::string interreflection_sentence(const Needs& needs) {
    const bool ambient = std::ranges::any_of(needs.materials, &MaterialNeeds::ambient);
    return std::string("light from one diffuse surface to another (colour bleeding): ") +
           (ambient ? "the ambient term stands in for it" : "not even an ambient term stands in for it") +
           "; see chapter 14";
}

}  // namespace

std::vector<LightPath> modelled_paths(const NeedsQuestion& question, const Needs& needs) {
    std::vector<LightPath> paths;
    const auto local = local_term(needs);
    const bool emission = std::ranges::any_of(needs.materials, &MaterialNeeds::emission);
    if (!local.empty()) paths.push_back({"L" + local + "E", local_sentence(local)});
    if (emission) paths.push_back({"LE", "a surface that sends out light is seen itself"});
    if (!needs.recursion || question.shows_only_background()) return paths;
    const auto on = times(needs.depth - 1);
    if (!local.empty()) paths.push_back({"L" + local + on + "E", "the same, seen " + by_what(needs)});
    if (emission) paths.push_back({"L" + on + "E", "a surface that sends out light, seen " + by_what(needs)});
    return paths;
}

std::vector<LightPath> missed_paths(const NeedsQuestion& question, const Needs& needs) {
    std::vector<LightPath> paths;
    if (needs.passed_on.stopped_by_limit)
        paths.push_back({fmt::format("L{}S{{{},}}E", local_term(needs), needs.depth),
                         fmt::format("over more than {} mirrors or glass surfaces: cut off by the limit of depth",
                                     needs.depth - 1)});
    const bool light = std::ranges::any_of(needs.lights, &LightNeeds::shines) ||
                       std::ranges::any_of(needs.materials, &MaterialNeeds::emission);
    const auto [diffuse, specular, intersect] = scatterers(question);
    if (!light || !diffuse || !intersect) return paths;
    paths.push_back({specular ? "L(D|S)*D(D|S)*DS*E" : "LDD+E", interreflection_sentence(needs)});
    if (specular)
        paths.push_back(
            {"LS+DS*E", "caustics, light gathered by a mirror or a glass on a diffuse surface; see chapter 17"});
    return paths;
}

}  // namespace raylab
