#include "raylab/scene/needs/spread.h"

#include "raylab/scene/pigment.h"

#include <fmt/format.h>

namespace raylab {

namespace {

// The names of the seen materials for which something holds.
std::vector<std::string> seen_with(const NeedsQuestion& question, const auto& holds) {
    const std::vector<bool> seen = seen_materials(question);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (seen[i] && holds(question.scene.materials[i])) names.push_back(material_name(question.scene, i));
    return names;
}

bool is_sharp(const Material& m) { return std::holds_alternative<Sharp>(m.polish); }
bool spreads(const Material& m) { return (m.kr > 0 || m.kt > 0) && !is_sharp(m); }

std::vector<std::string> emitting_objects(const Scene& scene) {
    const auto emits = [&](std::size_t material) { return scene.materials[material].emission != black; };
    std::vector<std::string> names;
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        if (emits(scene.objects[i].front) || emits(scene.objects[i].back)) names.push_back(name_of(scene, i));
    return names;
}

}  // namespace

SpreadFacts spread_facts(const NeedsQuestion& question, RenderModel model) {
    const Scene& scene = question.scene;
    const bool is_path = model == RenderModel::path;
    SpreadFacts facts{.model = model, .area_lights = emitting_objects(scene)};
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        if (scene.lights[i].color != black) facts.points.push_back(light_name(scene, i));
    facts.diffuse = seen_with(question, [](const Material& m) { return !is_black(m.diffuse); });
    facts.checkers =
        seen_with(question, [](const Material& m) { return !is_black(m.diffuse) && depends_on_point(m.diffuse); });
    facts.spreading = seen_with(question, spreads);
    facts.mirrors = seen_with(question, [](const Material& m) { return m.kr > 0; });
    facts.glass = seen_with(question, [](const Material& m) { return m.kt > 0; });
    facts.sharp_mirrors = seen_with(question, [](const Material& m) { return m.kr > 0 && is_sharp(m); });
    facts.sharp_glass = seen_with(question, [](const Material& m) { return m.kt > 0 && is_sharp(m); });
    facts.choosing = seen_with(
        question, [&](const Material& m) { return (m.kr > 0) + (m.kt > 0) + (is_path && !is_black(m.diffuse)) > 1; });
    facts.ambient =
        seen_with(question, [&](const Material& m) { return m.ambient * scene.background.ambient != black; });
    facts.highlights = seen_with(question, [](const Material& m) { return m.specular != black; });
    facts.emission = seen_with(question, [](const Material& m) { return m.emission != black; });
    return facts;
}

std::vector<Note> sample_dimensions(const NeedsQuestion& question, const Needs& needs, const SpreadFacts& facts) {
    std::vector<Note> notes{{"pixel", "2 numbers: where in the pixel"}};
    const Scene& scene = question.scene;
    if (needs.lens)
        notes.push_back({"lens", fmt::format("2 numbers: where on a lens of radius {}", scene.camera.lens->radius)});
    if (needs.time)
        notes.push_back({"time", fmt::format("1 number: when from {} to {} s, while something moves",
                                             scene.camera.shutter->open, scene.camera.shutter->close)});
    // Meshes, and polygons but rectangles, are lights of several parts, of which one is chosen.
    if (facts.area_lights.size() == 1)
        notes.push_back({"light", "2 numbers at a surface, 3 if it has parts: where on " + list_of(facts.area_lights)});
    else if (!facts.area_lights.empty())
        notes.push_back(
            {"light", "3 numbers at a surface: which area light, and where on it: " + list_of(facts.area_lights)});
    if (!facts.spreading.empty())
        notes.push_back(
            {"lobe", "2 numbers at a surface: the direction of gloss or roughness: " + list_of(facts.spreading)});
    if (!facts.choosing.empty())
        notes.push_back({"choice", "1 number at a surface: which lobe goes on: " + list_of(facts.choosing)});
    if (needs.model == RenderModel::path)
        notes.push_back({"diffuse", "2 numbers at a surface: the direction of a diffuse lobe; from the fourth surface "
                                    "on 1 for Russian roulette"});
    return notes;
}

std::vector<Note> unreached_light(const SpreadFacts& facts) {
    const bool is_path = facts.model == RenderModel::path;
    // A path finds a point's light by a lobe that spreads it: only what is sharp hides it. Of distributed rays diffuse
    // surfaces send none but shadow rays.
    const auto& glass = is_path ? facts.sharp_glass : facts.glass;
    const auto& mirrors = is_path ? facts.sharp_mirrors : facts.mirrors;
    const std::string why = is_path ? "no path hits a point; chapter 17" : "it sends out shadow rays alone; chapter 17";
    std::vector<std::string> sources = facts.points;
    if (!is_path) sources.insert(sources.end(), facts.area_lights.begin(), facts.area_lights.end());
    std::vector<Note> notes;
    if (!sources.empty() && !glass.empty())
        notes.push_back({"light through glass", list_of(sources) + " through " + list_of(glass) +
                                                    " onto a diffuse surface: glass stops shadow rays, and " + why});
    if (!sources.empty() && !mirrors.empty())
        notes.push_back(
            {"light by mirrors", list_of(sources) + " by " + list_of(mirrors) + " onto a diffuse surface: " + why});
    if (is_path && !(facts.mirrors.empty() && facts.glass.empty()) && !facts.area_lights.empty())
        notes.push_back({"caustics of area lights", "found where a path hits one by chance: with noise; chapter 17"});
    if (!is_path)
        notes.push_back({"diffuse to diffuse", "the ambient term stands in for it; --model path computes it"});
    if (is_path && !facts.ambient.empty())
        notes.push_back({"ambient term", "left out, of " + list_of(facts.ambient) + ": paths compute that light"});
    if (is_path && !facts.highlights.empty())
        notes.push_back({"highlights", "specular is left out, of " + list_of(facts.highlights) +
                                           ": it keeps no account of energy; gloss and roughness do"});
    return notes;
}

}  // namespace raylab
