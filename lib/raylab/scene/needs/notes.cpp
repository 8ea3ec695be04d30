#include "raylab/base/printable.h"
#include "raylab/scene/needs/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>

namespace raylab {

namespace {

std::vector<std::string> lights_with(const NeedsQuestion& question, const Needs& needs, bool LightNeeds::*property) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < needs.lights.size(); ++i)
        if (needs.lights[i].*property) names.push_back(light_name(question.scene, i));
    return names;
}

// Lights with the same reason share a line.
std::vector<Note> by_reason(const NeedsQuestion& question, const Needs& needs, const std::string& what,
                            const auto& concerns) {
    std::vector<std::pair<std::string, std::vector<std::string>>> groups;  // a reason and its lights
    for (std::size_t i = 0; i < needs.lights.size(); ++i) {
        const LightNeeds& light = needs.lights[i];
        if (!concerns(light)) continue;
        auto group = std::ranges::find(groups, light.why, &decltype(groups)::value_type::first);
        if (group == groups.end()) group = groups.insert(group, {light.why, {}});
        group->second.push_back(light_name(question.scene, i));
    }
    std::vector<Note> notes;
    for (const auto& [why, names] : groups) notes.push_back({what, list_of(names) + ": " + why});
    return notes;
}

void append(std::vector<Note>& notes, std::vector<Note> more) { std::ranges::move(more, std::back_inserter(notes)); }

struct Term {
    const char* name;
    bool MaterialNeeds::*property;
    const char* without;  // the reason why it can be left out
};

constexpr std::array terms{
    Term{"ambient term", &MaterialNeeds::ambient, "the ambient light is black, or what is seen reflects none of it"},
    Term{"diffuse term", &MaterialNeeds::diffuse, "nothing that is seen has a diffuse colour in the light"},
    Term{"highlights", &MaterialNeeds::highlight, "nothing that is seen has a specular colour in the light"},
    Term{"checkers", &MaterialNeeds::checker, "nothing that is seen in the light has a pattern"},
    Term{"emission", &MaterialNeeds::emission, "nothing that is seen sends out light"},
};

void left_out_of_recursion(std::vector<Note>& notes, const Needs& needs) {
    if (!needs.recursion)
        notes.push_back({"recursion", needs.passed_on.why});
    else if (!needs.passed_on.reflection)
        notes.push_back({"reflected rays", "nothing that is seen has a kr worth a ray"});
    else if (!needs.passed_on.transmission)
        notes.push_back({"transmitted rays", "nothing that is seen has a kt worth a ray"});
    if (needs.recursion && !needs.passed_on.stopped_by_limit)
        notes.push_back({fmt::format("rays deeper than {}", needs.depth), needs.passed_on.why});
}

}  // namespace

std::vector<Note> asked_for(const NeedsQuestion& question, const Needs& needs) {
    const Scene& scene = question.scene;
    std::vector<Note> notes;
    if (!needs.eye_rays) return notes;
    for (const auto& [name, property, without] : terms)
        if (const auto names = materials_with(scene, needs.materials, property); !names.empty())
            notes.push_back({name, list_of(names)});
    append(notes, by_reason(question, needs, "shadow rays", [](const LightNeeds& l) { return l.shadow_rays; }));
    if (const auto names = lights_with(question, needs, &LightNeeds::distance); !names.empty())
        notes.push_back(
            {"attenuation", list_of(names) + (names.size() == 1 ? " grows" : " grow") + " weaker with the distance"});
    if (const auto names = lights_with(question, needs, &LightNeeds::cone); !names.empty())
        notes.push_back({"cone of light", list_of(names)});
    if (needs.passed_on.reflection)
        notes.push_back(
            {"reflected rays", list_of(materials_with(scene, needs.materials, &MaterialNeeds::reflection))});
    if (needs.passed_on.transmission)
        notes.push_back(
            {"transmitted rays", list_of(materials_with(scene, needs.materials, &MaterialNeeds::transmission))});
    if (needs.recursion) notes.push_back({fmt::format("depth {}", needs.depth), needs.passed_on.why});
    if (needs.lens) notes.push_back({"lens samples", fmt::format("a lens of radius {}", scene.camera.lens->radius)});
    if (needs.time) notes.push_back({"time samples", "something moves while the shutter is open"});
    notes.push_back({"accelerator", needs.accelerator + ": " + primitives_of(needs)});
    if (needs.model == RenderModel::whitted)
        notes.push_back({"renderer", name_of(needs.renderer) + ": " + in_words(needs.renderer)});
    return notes;
}

std::vector<Note> left_out(const NeedsQuestion& question, const Needs& needs) {
    const Scene& scene = question.scene;
    if (!needs.eye_rays) return {{"every ray", "no object: every pixel shows the background"}};
    std::vector<Note> notes;
    append(notes, by_reason(question, needs, "lights", [](const LightNeeds& l) { return !l.shines; }));
    append(notes,
           by_reason(question, needs, "shadow rays", [](const LightNeeds& l) { return l.shines && !l.shadow_rays; }));
    if (scene.lights.empty()) notes.push_back({"shadow rays", "there is no light"});
    if (std::ranges::any_of(needs.lights, &LightNeeds::shines) &&
        std::ranges::none_of(needs.lights, &LightNeeds::distance))
        notes.push_back({"attenuation", "no light that shines grows weaker with the distance"});
    left_out_of_recursion(notes, needs);
    for (const auto& [name, property, without] : terms)
        if (materials_with(scene, needs.materials, property).empty()) notes.push_back({name, without});
    std::vector<std::string> unseen;
    for (std::size_t i = 0; i < needs.materials.size(); ++i)
        if (!needs.materials[i].seen) unseen.push_back(material_name(scene, i));
    if (!unseen.empty()) notes.push_back({"materials", list_of(unseen) + ": on no side of an object that is seen"});
    if (!needs.lens) notes.push_back({"lens samples", "the camera is a pinhole: everything is in focus"});
    if (!needs.time) notes.push_back({"time samples", why_no_time(scene)});
    if (needs.accelerator.ends_with("list")) notes.push_back({"a tree", primitives_of(needs) + ": a list is faster"});
    return notes;
}

std::vector<Note> missed_effects(const NeedsQuestion& question, const Needs& needs) {
    if (!needs.eye_rays) return {};
    std::vector<Note> notes;
    if (needs.shadows)
        notes.push_back({"soft shadows", "lights are points: edges of shadows are sharp; see chapter 15"});
    const auto glass = [&](const Material& m) { return m.kt > 0; };
    const auto seen = seen_materials(question);
    bool any_glass = false;
    for (std::size_t i = 0; i < seen.size(); ++i)
        any_glass = any_glass || (seen[i] && glass(question.scene.materials[i]));
    if (needs.shadows && any_glass)
        notes.push_back({"shadows of glass", "glass stops shadow rays as if it were opaque; see chapter 17"});
    if (needs.passed_on.reflection)
        notes.push_back({"blurred mirrors", "a mirror is perfect, however broad its highlights; see chapter 15"});
    if (std::ranges::any_of(needs.materials, &MaterialNeeds::refraction))
        notes.push_back({"dispersion", "one index of refraction for all colours: no rainbow"});
    if (std::ranges::any_of(needs.materials, &MaterialNeeds::emission))
        notes.push_back({"light of emitting surfaces", "they are seen but light nothing; see chapters 14 and 15"});
    if (needs.lens) notes.push_back({"depth of field", "Whitted's eye is a pinhole; see chapter 15"});
    if (needs.time) notes.push_back({"motion blur", "Whitted's shutter is open for an instant; see chapter 15"});
    notes.push_back(
        {"smooth edges", "a ray has no width: edges are stairs unless a pixel takes several; see chapter 15"});
    return notes;
}

std::string why_no_time(const Scene& scene) {
    const auto& shutter = scene.camera.shutter;
    if (!shutter || shutter->open == shutter->close) return "the shutter is open for an instant";
    return "nothing moves";
}

std::string primitives_of(const Needs& needs) {
    return needs.primitives == 1 ? "1 primitive" : fmt::format("{} primitives", needs.primitives);
}

std::string list_of(std::span<const std::string> names) {
    constexpr std::size_t largest = 4;  // as many as fit on a line
    std::string text;
    for (const auto& name : names.first(std::min(largest, names.size())))
        text += (text.empty() ? "" : ", ") + printable(name);
    return names.size() > largest ? text + fmt::format(" and {} more", names.size() - largest) : text;
}

}  // namespace raylab
