#include "raylab/base/printable.h"
#include "raylab/base/wrapped_text.h"
#include "raylab/scene/needs.h"
#include "raylab/scene/needs/parts.h"
#include "raylab/scene/render_model.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace raylab {

namespace {

std::string counted(std::size_t n, const std::string& one) { return fmt::format("{} {}{}", n, one, n == 1 ? "" : "s"); }

constexpr std::size_t left = 24, right = 84;  // columns: the fact and its reason; 112 with the margins

// Each line after the first is indented to the right column.
std::string in_right_column(const std::string& sentence) {
    return fmt::format("{}", fmt::join(wrapped(sentence, right), "\n" + std::string(left + 4, ' ')));
}

std::string section(const std::string& title, const std::vector<Note>& notes) {
    if (notes.empty()) return "";
    std::string text = "\n" + title + "\n";
    for (const auto& [what, why] : notes) {
        const bool long_name = what.size() > left;
        text += fmt::format("  {:<{}}{}", what, left, long_name ? "\n" + std::string(left + 2, ' ') : "");
        text += "  " + in_right_column(why) + "\n";
    }
    return text;
}

std::string without_light(const Needs& needs) {
    if (!needs.eye_rays) return "\nThere is nothing to see: the picture is the background.\n";
    const bool ambient = std::ranges::any_of(needs.materials, &MaterialNeeds::ambient);
    return std::string("\nNo path leads from a light to the eye: the picture shows the background and ") +
           (ambient ? "what the ambient term gives.\n" : "black shapes before it.\n");
}

std::vector<Note> as_notes(const std::vector<LightPath>& paths) {
    std::vector<Note> notes;
    for (const auto& [expression, sentence] : paths) notes.push_back({expression, sentence});
    return notes;
}

nlohmann::ordered_json to_json(const std::vector<Note>& notes) {
    auto array = nlohmann::ordered_json::array();
    for (const auto& [what, why] : notes) array.push_back({{"what", what}, {"why", why}});
    return array;
}

nlohmann::ordered_json to_json(const std::vector<LightPath>& paths) {
    auto array = nlohmann::ordered_json::array();
    for (const auto& [expression, sentence] : paths)
        array.push_back({{"expression", expression}, {"sentence", sentence}});
    return array;
}

nlohmann::ordered_json lights_json(const Needs& needs, const Scene& scene) {
    auto array = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < needs.lights.size(); ++i) {
        const auto& [shines, shadow_rays, distance, cone, why] = needs.lights[i];
        array.push_back({{"name", light_name(scene, i)},
                         {"shines", shines},
                         {"shadow_rays", shadow_rays},
                         {"distance", distance},
                         {"cone", cone},
                         {"why", why}});
    }
    return array;
}

nlohmann::ordered_json materials_json(const Needs& needs, const Scene& scene) {
    auto array = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < needs.materials.size(); ++i) {
        const auto& m = needs.materials[i];
        array.push_back({{"name", material_name(scene, i)},
                         {"seen", m.seen},
                         {"ambient", m.ambient},
                         {"diffuse", m.diffuse},
                         {"checker", m.checker},
                         {"highlight", m.highlight},
                         {"emission", m.emission},
                         {"reflection", m.reflection},
                         {"transmission", m.transmission},
                         {"refraction", m.refraction}});
    }
    return array;
}

}  // namespace

std::string to_text(const Needs& needs, const Scene& scene) {
    std::vector<Note> missed = as_notes(needs.missed_paths);
    missed.insert(missed.end(), needs.missed.begin(), needs.missed.end());
    std::string text = fmt::format("{}: {}, {}, {}\n", scene.source.empty() ? "scene" : printable(scene.source),
                                   counted(scene.objects.size(), "object"), counted(scene.lights.size(), "light"),
                                   counted(scene.materials.size(), "material"));
    text += section("Look at this first", needs.warnings);
    text += section("Light paths (L light, D diffuse, S specular, E eye)", as_notes(needs.paths));
    if (needs.paths.empty()) text += without_light(needs);
    text += section("What must be modelled", needs.asked);
    text += section("What is left out: the picture is the same without it", needs.left_out);
    if (needs.model == RenderModel::whitted) return text + section("What Whitted's method does not show", missed);
    text += section("What the random numbers of a sample are for: model " + to_string(needs.model), needs.dimensions);
    text += section("What this model does not show, or by chance alone", needs.unreached);
    text += section("What Whitted's method would not show", missed);
    return text;
}

nlohmann::ordered_json to_json(const Needs& needs, const Scene& scene) {
    return {{"scene", scene.source},
            {"objects", scene.objects.size()},
            {"primitives", needs.primitives},
            {"eye_rays", needs.eye_rays},
            {"shadows", needs.shadows},
            {"recursion", needs.recursion},
            {"depth", needs.depth},
            {"stopped_by_limit", needs.passed_on.stopped_by_limit},
            {"reflection", needs.passed_on.reflection},
            {"transmission", needs.passed_on.transmission},
            {"coefficient", needs.passed_on.coefficient},
            {"lens", needs.lens},
            {"time", needs.time},
            {"accelerator", needs.accelerator},
            {"renderer", name_of(needs.renderer)},
            {"model", to_string(needs.model)},
            {"dimensions", to_json(needs.dimensions)},
            {"unreached", to_json(needs.unreached)},
            {"paths", to_json(needs.paths)},
            {"missed_paths", to_json(needs.missed_paths)},
            {"lights", lights_json(needs, scene)},
            {"materials", materials_json(needs, scene)},
            {"asked", to_json(needs.asked)},
            {"left_out", to_json(needs.left_out)},
            {"missed", to_json(needs.missed)},
            {"warnings", to_json(needs.warnings)}};
}

}  // namespace raylab
